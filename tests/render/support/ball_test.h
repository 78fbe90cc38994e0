#pragma once

#include <cmath>

#include "render/gl/read_pixels.h"
#include "render/raycaster.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {

inline constexpr float kRadius = 12;
inline const glm::dvec3 kCentre(31, -20, 55);
inline constexpr glm::ivec2 kSize(160, 120);

// ball: of radius 12 mm, bright inside, on a turned grid of unequal spacing; iso-value 0.5.
inline Volume<float> ball() {
  Geometry g;
  g.dims = {48, 70, 40};
  g.spacing = {0.8, 0.5, 1.0};
  const double c = std::cos(0.4), s = std::sin(0.4);
  g.direction = glm::dmat3(glm::dvec3(c, s, 0), glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1));
  g.origin = kCentre - g.direction * (g.spacing * 0.5 * glm::dvec3(g.dims - 1));
  Volume<float> volume(g);
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const double r = glm::length(g.toWorld({i, j, k}) - kCentre);
        volume.at(i, j, k) = float(glm::clamp(0.5 + 0.12 * (kRadius - r), 0.0, 1.0));
      }
  return volume;
}

// BallTest: that ball, and what casts rays at it.
class BallTest : public GlTest {
 protected:
  BallTest() { volume_.set(std::make_shared<Volume<float>>(ball())); }

  // cast: draws the ball as a surface and keeps the surface buffer.
  void cast(float raysPerPixel = 1) {
    camera_ = parseCamera("front,azimuth=25,elevation=10", Beam{}, worldBox(volume_.geometry()), 4.0f / 3);
    target_ = gl::Framebuffer({.size = kSize});
    raycaster_.draw({.volume = volume_,
                     .camera = camera_,
                     .lighting = portraitLighting(camera_),
                     .raysPerPixel = raysPerPixel},
                    target_);
  }
  GpuVolume volume_;
  Camera camera_;
  gl::Framebuffer target_;
  Raycaster raycaster_;
};

}  // namespace sonoskin
