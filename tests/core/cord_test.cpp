#include "core/phantom/cord.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin {
namespace {

using glm::vec3;

Cord straight() { return makeCord({{-40, 0, 0}, {-20, 0, 0}, {0, 0, 0}, {20, 0, 0}, {40, 0, 0}}, 6); }

TEST(Cord, HasThreeRidgesThatWind) {
  const Cord cord = straight();
  for (const float x : {-12.f, 0.f, 9.f}) {
    int rises = 0;
    double least = 10, most = 0, before = 0;
    for (int n = 0; n <= 360; ++n) {
      const float angle = glm::radians(float(n)), r = 8;
      const double radius = double(r - cordDistance(cord, {x, r * std::cos(angle), r * std::sin(angle)}));
      least = std::min(least, radius), most = std::max(most, radius);
      rises += n > 0 && before <= 5.46 && radius > 5.46;  // 6 (1 - 0.09)
      before = radius;
    }
    EXPECT_EQ(rises, 3) << x;
    EXPECT_NEAR(most, 6, 0.02);
    EXPECT_NEAR(least, 6 * (1 - 2 * 0.09), 0.02);
  }
  EXPECT_GT(std::abs(cordDistance(cord, {0, 8, 0}) - cordDistance(cord, {5, 8, 0})), 0.3f)
      << "a third of a turn";
}

TEST(Cord, FollowsItsCurve) {
  const Cord cord = makeCord({{0, 0, 0}, {20, 10, 0}, {40, 0, 10}, {60, -10, 10}, {80, 0, 0}}, 5);
  EXPECT_NEAR(cordDistance(cord, {40, 0, 10}), -5, 1);  // through the points
  EXPECT_NEAR(cordDistance(cord, {20, 10, 0}), -5, 1);
  EXPECT_GT(cordDistance(cord, {5, 0, 0}), 5) << "it begins at the second point";
}

TEST(Cord, IsADistance) {
  const Cord cord = straight();
  for (int n = 0; n < 3000; ++n) {
    const vec3 p(0.021f * float(n % 1000) - 10, 9 * std::sin(0.7f * float(n)), 9 * std::cos(1.3f * float(n)));
    const vec3 q = p + 0.01f * vec3(std::sin(float(n)), std::cos(2.f * float(n)), std::sin(3.f * float(n)));
    if (glm::length(vec3(0, p.y, p.z)) < 4) continue;
    ASSERT_LT(std::abs(cordDistance(cord, p) - cordDistance(cord, q)), 1.25f * glm::distance(p, q) + 1e-4f);
  }
}

TEST(Cord, WithoutPointsThereIsNone) {
  EXPECT_TRUE(makeCord({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 6).axis.empty());
  EXPECT_GT(cordDistance(Cord{}, {0, 0, 0}), 100);
}

}  // namespace
}  // namespace sonoskin
