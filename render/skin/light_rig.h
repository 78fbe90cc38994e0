#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/skin/light_options.h"
#include "render/camera.h"

namespace sonoskin {

// SkinLight: one light on the skin.
//   position    far: unit direction toward it; near, inside: world mm
//   colour      irradiance / pi of a surface that faces it (white shows this colour); near, inside: at `reach` mm from it
//   softness    tangent of the light's radius as seen from the skin
struct SkinLight {
  LightKind kind = LightKind::far;
  glm::vec3 position{0, 0, 1};
  glm::vec3 colour{1};
  float reach = 100;
  float softness = 0.05f;
  bool shadows = true;
};

// LightRig: all lights. The first one is the movable one.
//   environment  radiance from all around as spherical harmonics: 9 coefficients, order (0,0) (1,-1) (1,0) (1,1) (2,-2) ...
//   exposure     factor
struct LightRig {
  static constexpr int kMost = 3;
  std::vector<SkinLight> lights;
  std::array<glm::vec3, 9> environment{};
  float exposure = 1;

  // light: number i, or a dark one where there are fewer.
  SkinLight light(std::size_t i) const {
    return i < lights.size() ? lights[i] : SkinLight{.colour = glm::vec3(0), .shadows = false};
  }
};

// HomeFrame: what "right", "up" and "toward the viewer" mean for LightOptions; unit vectors.
struct HomeFrame {
  glm::vec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};
};
HomeFrame homeFrame(const Camera& camera);

// makeLightRig: the lights of the options around a box.
LightRig makeLightRig(const LightOptions& options, const HomeFrame& home, const Box& box);

// lightPlace: the unit direction from the box's middle to the movable light; lightAngles: its inverse, {azimuth,
// elevation} in degrees.
glm::vec3 lightPlace(const LightOptions& options, const HomeFrame& home);
glm::vec2 lightAngles(const glm::vec3& direction, const HomeFrame& home);

}  // namespace sonoskin
