#include "core/phantom/fetal_body.h"

#include "core/phantom/sdf.h"

namespace sonoskin {

using namespace sdf;

float bodySkin(const glm::vec3& p) {
  const vec3 q{std::abs(p.x), p.y, p.z};
  const float chest = ellipsoid(p, {0, -88, -10}, {37, 40, 29});
  return smoothMin(chest, capsule(q, {{4, -53, -14}, 15}, {kShoulder - vec3(4, 1, 2), 13}), 9);  // shoulders
}

float rightArmSkin(const glm::vec3& p) { return capsule(p, {{-37, -60, -5}, 11.5f}, {{-50, -102, 0}, 9}); }

float bodyBone(const glm::vec3& p) {
  const float chest = ellipsoid(p, {0, -88, -10}, {31, 35, 24});
  const float rib = std::cos(0.75f * (p.y + 0.25f * p.z)) * 1.4f - 0.2f;
  const float ribs = std::max({chest, -(chest + 1.8f), rib});
  return std::min(ribs, capsule({std::abs(p.x), p.y, p.z}, {{3, -59, 4}, 1.4f}, {kShoulder, 1.6f}));
}

}  // namespace sonoskin
