#include "app/document/crop_box.h"

#include <gtest/gtest.h>

#include "core/surface/region.h"
#include "tests/support/volumes.h"

namespace sonoskin {
namespace {

Geometry turned() {
  Geometry g = test::turnedGeometry();
  g.dims = {41, 31, 21};  // 20 x 22.5 x 25 mm between the outermost centres
  return g;
}

TEST(CropBox, SidesAreMillimetresAlongTheAxes) {
  const RegionOptions options{{1, 2, 3}, {4, 5, 6}};
  EXPECT_DOUBLE_EQ(sideAt({0, false}, options, turned()), 1);
  EXPECT_DOUBLE_EQ(sideAt({0, true}, options, turned()), 16);
  EXPECT_DOUBLE_EQ(sideAt({2, true}, options, turned()), 19);
}

TEST(CropBox, ASideGoesWhereItIsMovedAndLeavesSomething) {
  const Geometry g = turned();
  RegionOptions options;
  moveSide({1, false}, 7.26, options, g);
  EXPECT_DOUBLE_EQ(options.cutLow[1], 7.3);
  moveSide({1, true}, 12.0, options, g);
  EXPECT_DOUBLE_EQ(sideAt({1, true}, options, g), 12);
  moveSide({1, true}, -50, options, g);  // through the other side
  EXPECT_GE(sideAt({1, true}, options, g), sideAt({1, false}, options, g) + 1 - 1e-9);
  Scan scan;
  scan.volume = std::make_shared<const Volume<float>>(Volume<float>(g));
  EXPECT_NO_THROW(regionOf(scan, options));
  moveSide({1, true}, 900, options, g);  // out of the volume
  EXPECT_DOUBLE_EQ(options.cutHigh[1], 0);
  EXPECT_DOUBLE_EQ(options.cutLow[1], 7.3);
}

TEST(CropBox, CornersLieHalfAVoxelBeyond) {
  const Geometry g = turned();
  const auto [low, high] = boxCorners({{1, 0, 0}, {0, 0, 2.5}}, g);
  const glm::dvec3 first = g.toIndex(low), last = g.toIndex(high);
  EXPECT_NEAR(glm::distance(first, glm::dvec3(1.5, -0.5, -0.5)), 0, 1e-9);
  EXPECT_NEAR(glm::distance(last, glm::dvec3(40.5, 30.5, 18.5)), 0, 1e-9);
}

TEST(CropBox, ACoarserVolumeHasTheSameBox) {
  const Geometry g = turned();
  Geometry coarse = g;
  coarse.spacing *= 2.0;
  coarse.origin = g.toWorld(glm::dvec3(0.5));
  const RegionOptions options{{1, 2, 3}, {4, 5, 6}};
  const auto fine = boxIn(g, options, g), few = boxIn(coarse, options, g);
  for (int end = 0; end < 2; ++end)
    EXPECT_NEAR(glm::distance(g.toWorld(fine[std::size_t(end)]), coarse.toWorld(few[std::size_t(end)])), 0,
                1e-9);
}

TEST(CropBox, TheMouseTakesTheSidesNearIt) {
  const auto grip = [](double x, double y) {
    const Grip g = gripAt({100, 50}, {300, 250}, {x, y}, 5);
    return std::pair(g.right, g.down);
  };
  EXPECT_EQ(grip(102, 150), std::pair(-1, 0));
  EXPECT_EQ(grip(296, 150), std::pair(1, 0));
  EXPECT_EQ(grip(200, 47), std::pair(0, -1));
  EXPECT_EQ(grip(200, 254), std::pair(0, 1));
  EXPECT_EQ(grip(99, 52), std::pair(-1, -1)) << "a corner holds two sides";
  EXPECT_EQ(grip(303, 247), std::pair(1, 1));
  EXPECT_EQ(grip(200, 150), std::pair(0, 0)) << "inside";
  EXPECT_EQ(grip(100, 260), std::pair(0, 0)) << "beyond the end of a side";
  const Grip thin = gripAt({100, 50}, {104, 250}, {103, 150}, 5);
  EXPECT_EQ(thin.right, 1) << "the nearer of two sides";
}

}  // namespace
}  // namespace sonoskin
