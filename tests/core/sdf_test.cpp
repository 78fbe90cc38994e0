#include "core/phantom/sdf.h"

#include <gtest/gtest.h>

#include <array>

namespace sonoskin::sdf {
namespace {

TEST(Sdf, SmoothMinStaysBetweenMinAndASixthOfItsRadiusBelow) {
  for (float a = -3; a <= 3; a += 0.05f)
    for (float k : {0.5f, 2.f}) {
      const float m = smoothMin(a, 0, k), sharp = std::min(a, 0.f);
      EXPECT_LE(m, sharp);
      EXPECT_GE(m, sharp - k / 6 - 1e-6f);
      if (std::abs(a) >= k) {
        EXPECT_EQ(m, sharp);
      }
      EXPECT_FLOAT_EQ(smoothMax(-a, 0, k), -m);
    }
}

TEST(Sdf, EllipsoidIsASphereForEqualRadii) {
  EXPECT_NEAR(ellipsoid({3, 4, 12}, {0, 0, 0}, {5, 5, 5}), 8, 1e-5);
  EXPECT_NEAR(sphere({3, 4, 12}, {0, 0, 0}, 5), 8, 1e-5);
}

TEST(Sdf, EllipsoidVanishesOnItsSurfaceWithUnitSlope) {
  const vec3 radii(9, 4, 6), on = radii * glm::normalize(vec3(1, 2, -1));
  const vec3 normal = glm::normalize(on / (radii * radii));
  EXPECT_NEAR(ellipsoid(on, vec3(0), radii), 0, 1e-5);
  EXPECT_NEAR(ellipsoid(on + 0.01f * normal, vec3(0), radii), 0.01, 1e-4);
}

TEST(Sdf, ChainIsTheNearestOfItsCapsules) {
  const std::array<Joint, 3> bent{{{{0, 0, 0}, 1}, {{10, 0, 0}, 2}, {{10, 10, 0}, 1}}};
  EXPECT_NEAR(chain({5, -4, 0}, bent, 0.1f), 4 - 1.5, 1e-5);
  EXPECT_NEAR(chain({14, 5, 0}, bent, 0.1f), 4 - 1.5, 1e-5);
}

TEST(Sdf, BumpIsSmoothAndNoSteeperThanItSays) {
  EXPECT_EQ(bump(0), 1);
  EXPECT_EQ(bump(1), 0);
  EXPECT_EQ(bump(-2), 0);
  for (float x = -1.2f; x < 1.2f; x += 0.01f) EXPECT_LE(std::abs(bump(x + 0.01f) - bump(x)), 0.01f * 1.55f);
}

TEST(Sdf, ReachSkipsOnlyWhatHasNoInfluence) {
  const Reach reach{{1, 2, 3}, 4};
  int unjoined = 0, uncarved = 0, near = 0;
  for (float x = -20; x < 20; x += 0.37f)
    for (float d : {-3.f, 0.f, 2.f, 9.f}) {
      const vec3 p(x, 0.4f * x, 3);
      const float ball = sphere(p, reach.centre, reach.radius);
      near += smoothMin(d, ball, 1) != d || smoothMax(d, -ball, 1) != d;
      if (!reach.joins(p, d, 1)) {
        EXPECT_EQ(smoothMin(d, ball, 1), d);
        ++unjoined;
      }
      if (!reach.carves(p, d, 1)) {
        EXPECT_EQ(smoothMax(d, -ball, 1), d);
        ++uncarved;
      }
    }
  EXPECT_GT(near, 20);
  EXPECT_GT(unjoined, 100) << "most is too far away";
  EXPECT_GT(uncarved, 100);
}

}  // namespace
}  // namespace sonoskin::sdf
