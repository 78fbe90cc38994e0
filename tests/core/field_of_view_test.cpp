#include "core/volume/field_of_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// A sector that opens by 30 degrees to either side of the j axis, seen from above.
TEST(FieldOfView, IsTheSectorOfAPaddedScan) {
  const Geometry g = test::grid({80, 60, 20}, {0.5, 0.5, 1.0});
  const double slope = std::tan(0.5235988);
  const auto volume =
      test::fill(g, [&](glm::dvec3 p) { return std::abs(p.x - 20) < slope * p.y ? 0.5 : 0.0; });
  const FieldOfView view = findFieldOfView(volume, {});
  EXPECT_GT(view.sides.size(), 0u);
  for (const double depth : {2.0, 5.0, 8.0}) {
    // On the middle line at y = 20 a side plane is y sin 30 away; move `depth` toward it.
    const glm::vec3 p(float(20 + slope * 20 - depth / std::cos(0.5235988)), 20, 9.5f);
    EXPECT_NEAR(view.depth(p), depth, 0.6);  // to a voxel
    EXPECT_TRUE(view.contains(p));
  }
  EXPECT_LT(view.depth({38, 10, 9}), 0);
  EXPECT_FALSE(view.contains({38, 10, 9}));
}

TEST(FieldOfView, LeavesTheSideTowardTheProbeFree) {
  const Geometry g = test::grid({40, 40, 40});
  const auto ball = test::fill(g, [](glm::dvec3 p) { return glm::length(p - 20.0) < 12 ? 0.8 : 0.0; });
  const FieldOfView view = findFieldOfView(ball, {});
  EXPECT_GT(view.depth({20, 8.5f, 20}), 3);   // half a millimetre inside the ball: its front is anatomy
  EXPECT_LT(view.depth({20, 31.5f, 20}), 1);  // its back could be the end of the recording
}

TEST(FieldOfView, OfAnUnpaddedVolumeIsItsBox) {
  const Volume<float> full(test::grid({20, 30, 25}, {1, 0.5, 2}), 0.3f);
  const FieldOfView view = findFieldOfView(full, {});
  EXPECT_NEAR(view.depth({4, 7, 20}), 4, 1e-3);
  EXPECT_NEAR(view.depth({10, 12.5f, 20}), 2, 1e-3);  // from the far side, j = 29
}

TEST(FieldOfView, OfAnEmptyOrFlatVolumeHasNoPlanes) {
  EXPECT_TRUE(findFieldOfView(Volume<float>(test::grid({9, 9, 9})), {}).sides.empty());
  Volume<float> flat(test::grid({9, 9, 9}));
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) flat.at(i, j, 4) = 1;
  EXPECT_TRUE(findFieldOfView(flat, {}).sides.empty());
}

}  // namespace
}  // namespace sonoskin
