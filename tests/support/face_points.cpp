#include "tests/support/face_points.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "core/phantom/fetal_arm.h"
#include "core/phantom/fetal_body.h"
#include "core/phantom/fetal_head.h"
#include "core/phantom/random_field.h"
#include "core/phantom/sdf.h"

namespace sonoskin::test {
namespace {

using glm::vec3;

float babySkin(const vec3& p, const HeadShape& shape, bool arm) {
  const vec3 unit = p / shape.size;
  float d = sdf::smoothMin(headSkin(p, shape), shape.size * bodySkin(unit), 5);
  if (arm) d = sdf::smoothMin(d, shape.size * firstArmSkin(unit), 1.2f);
  return d;
}

vec3 gradientOf(const std::function<float(const vec3&)>& distance, const vec3& p) {
  constexpr float kStep = 0.05f;
  vec3 g;
  for (int axis = 0; axis < 3; ++axis) {
    vec3 h(0);
    h[axis] = kStep;
    g[axis] = distance(p + h) - distance(p - h);
  }
  return glm::normalize(g);
}

Volume<float> insideOf(const std::function<float(const vec3&)>& distance, float half) {
  constexpr double kVoxel = 3;
  Geometry geometry;
  geometry.dims = glm::ivec3(int(2 * double(half) / kVoxel));
  geometry.spacing = glm::dvec3(kVoxel);
  geometry.origin = glm::dvec3(-double(half));
  Volume<float> volume(geometry);
  for (int k = 0; k < geometry.dims.z; ++k)
    for (int j = 0; j < geometry.dims.y; ++j)
      for (int i = 0; i < geometry.dims.x; ++i)
        volume.at(i, j, k) = distance(vec3(geometry.toWorld({i, j, k}))) < 0 ? 1.f : 0.f;
  return volume;
}

}  // namespace

SurfacePoints sampleSurface(const std::function<float(const vec3&)>& distance, float half,
                            const SampleOptions& options) {
  constexpr float kFacing = 0.25f, kGrain = 3;
  SurfacePoints points;
  const std::uint32_t key = streamKey(int(options.seed), 3);
  std::uint32_t index = 0;
  const auto add = [&](const vec3& p, const vec3& n) {
    points.positions.push_back(p);
    points.normals.push_back(n);
    points.confidence.push_back(1);
  };
  for (float y = -half; y < half; y += options.spacing)
    for (float x = -half; x < half; x += options.spacing) {
      vec3 p(x, y, half);
      float d = distance(p);
      for (; d > 0.01f && p.z > -half; d = distance(p)) p.z -= 0.75f * d;
      if (p.z <= -half) continue;
      const vec3 n = gradientOf(distance, p);
      if (n.z < kFacing) continue;
      const float off =
          options.noise * (0.5f * normalAt(index++, key) + 3 * (valueNoise(p + half, kGrain, key) - 0.5f));
      add(p + off * n, n);
    }
  const auto strays = std::size_t(options.outliers * float(points.size()));
  for (std::size_t n = 0; n < strays; ++n) {
    const auto in = [&] { return 2 * uniformAt(index++, key) - 1; };
    const vec3 p{in(), in(), in()};
    const vec3 q{in(), in(), in()};
    add(0.6f * half * p, glm::normalize(q + vec3(0, 0, 1)));
  }
  return points;
}

SampledFace sampleFace(const HeadShape& shape, const glm::vec3& yawPitchRoll, const SampleOptions& options) {
  constexpr float kHalf = 75;
  SampledFace face;
  face.shape = shape;
  const vec3 angles = glm::radians(yawPitchRoll);
  const glm::quat turn = glm::angleAxis(angles.z, vec3(0, 0, 1)) * glm::angleAxis(angles.y, vec3(1, 0, 0)) *
                         glm::angleAxis(angles.x, vec3(0, 1, 0));
  face.turn = glm::mat3_cast(turn);
  face.at = vec3(4, -3, -12);
  const float border = shape.size * 37 - options.hidden;
  const auto distance = [&](const vec3& p) {
    const vec3 head = glm::transpose(face.turn) * (p - face.at);
    const float d = babySkin(head, shape, options.arm);
    return options.hidden > 0 ? std::max(d, head.x - border) : d;
  };
  face.points = sampleSurface(distance, kHalf, options);
  face.volume = insideOf(distance, kHalf);
  return face;
}

}  // namespace sonoskin::test
