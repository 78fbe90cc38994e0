#include "core/phantom/membranes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin {
namespace {

using glm::vec3;

// The skin is the plane y = 40, the wall the plane y = 10, as the probe sees them.
float skin(const vec3& p) { return 40 - p.y; }
float wall(const vec3& p) { return p.y - 10; }

std::vector<Membrane> three() {
  const std::vector<vec3> starts{{0, 40, 0}, {20, 40, 0}, {30, 40, 0}, {60, 40, 0}};
  return spanMembranes(starts, std::vector<vec3>(4, {0, -1, 0}), skin, wall, 7);
}

TEST(Membranes, StrandsAndSheetsAreAsThinAsTheySay) {
  const std::vector<Membrane> m = three();
  ASSERT_EQ(m.size(), 3u);
  EXPECT_FALSE(m[0].sheet);
  EXPECT_TRUE(m[1].sheet);
  for (const Membrane& one : m) {
    EXPECT_GE(one.thickness, 0.5f);
    EXPECT_LE(one.thickness, 1.5f);
  }
  EXPECT_NEAR(membraneDistance(m, {0, 25, 3}), 3 - 0.5f * m[0].thickness, 1e-4);
  EXPECT_NEAR(membraneDistance(m, {25, 25, 2}), 2 - 0.5f * m[1].thickness, 1e-4) << "the sheet's middle";
  EXPECT_NEAR(membraneDistance(m, {25, 25, 0}), -0.5f * m[1].thickness, 1e-4);
  EXPECT_LT(membraneDistance(m, {0, 40, 0}), -0.5f * m[0].thickness - 0.5f) << "thicker at the roots";
}

TEST(Membranes, EndInTheWall) {
  for (const Membrane& one : three()) {
    EXPECT_LT(wall(one.corners[1]), -1);
    EXPECT_GT(wall(one.corners[1]), -2);
    EXPECT_EQ(skin(one.corners[0]), 0);
  }
}

TEST(Membranes, WhereThereIsNoWallThereIsNone) {
  EXPECT_TRUE(spanMembranes({{0, 40, 0}}, {{0, 0, 1}}, skin, wall, 7).empty());
  EXPECT_GT(membraneDistance({}, {0, 0, 0}), 100);
}

TEST(Membranes, SkinInTheWayEndsThem) {
  const auto shelf = [](const vec3& p) { return std::min(skin(p), std::abs(p.y - 25) - 2); };
  EXPECT_TRUE(spanMembranes({{0, 40, 0}}, {{0, -1, 0}}, shelf, wall, 7).empty());
}

}  // namespace
}  // namespace sonoskin
