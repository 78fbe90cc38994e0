#pragma once

#include <functional>

#include "core/face/face_space.h"
#include "core/phantom/head_shape.h"

namespace sonoskin::test {

// SampledFace: a baby as a scanner would see it from z = +infinity, without the scanner: points where rays along -z
// first meet its skin, and a coarse volume that is 1 in it and 0 in the fluid around it.
//   turn, at   the head's frame in the world: world = at + turn * head
struct SampledFace {
  HeadShape shape;
  glm::mat3 turn{1};
  glm::vec3 at{0};
  SurfacePoints points;
  Volume<float> volume;
  Beam beam{std::nullopt, {0, 0, -1}, {0, 1, 0}};

  FaceInput input() const { return {points, &volume, 0.5f, beam}; }
};

// SampleOptions: what is made worse.
//   noise      mm along the normals, in grains of some mm
//   outliers   share of points that lie anywhere
//   hidden     mm of the head, from its left side on, that no ray reaches
//   arm        with the left hand before the mouth
struct SampleOptions {
  float spacing = 0.8f;
  float noise = 0;
  float outliers = 0;
  float hidden = 0;
  bool arm = false;
  std::uint32_t seed = 1;
};

// sampleFace: a head turned by the angles: about its own up (yaw) and left (pitch), then in the picture (roll); degrees.
SampledFace sampleFace(const HeadShape& shape, const glm::vec3& yawPitchRoll,
                       const SampleOptions& options = {});

// sampleSurface: the same of any signed distance within `half` mm around the origin; without a volume.
SurfacePoints sampleSurface(const std::function<float(const glm::vec3&)>& distance, float half,
                            const SampleOptions& options = {});

}  // namespace sonoskin::test
