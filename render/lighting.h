#pragma once

#include <glm/glm.hpp>
#include <string_view>

#include "render/camera.h"
#include "render/gl/program.h"

namespace sonoskin {

// Light: a far light.
//   direction  unit, toward the light
//   colour     irradiance / pi, linear: a white surface that faces it shows this colour
struct Light {
  glm::vec3 direction{0, 0, 1};
  glm::vec3 colour{1};
};

// Lighting: a key light that casts shadows, a fill from the other side, a rim from behind, and light from all
// around that is stronger from above; the background is part of it.
struct Lighting {
  Light key, fill, rim;
  glm::vec3 sky{0.2f}, ground{0.1f}, skyDirection{0, 0, 1};
  glm::vec3 backgroundTop{0.02f}, backgroundBottom{0.005f};  // display-linear
  bool background = true;                                    // without it, what is not covered is transparent
  float exposure = 1;
};

// portraitLighting: the studio set-up around a camera: key from above and the left, warm; fill from the
// right, cool.
Lighting portraitLighting(const Camera& camera);

// parseLighting: the studio set-up with the key light moved, from words.
//   text    "portrait", or comma-separated azimuth=<degrees to the camera's right>, elevation=<degrees upward>, where
//           0 and 0 are the camera's own place, and strength=<factor>
//   errors  Error (usage): an unknown word, not a number, strength not within 0 to 100
Lighting parseLighting(std::string_view text, const Camera& camera);

// setLights: the uniforms of shaders/common/lighting.glsl, the background and the exposure.
void setLights(gl::Program& program, const Lighting& lighting);

}  // namespace sonoskin
