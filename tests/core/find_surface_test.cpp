#include "core/surface/find_surface.h"

#include <gtest/gtest.h>

#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// An arm before a face, and its shadow between: bright layers across j, which begin at 10 and 20; u is 0.9 where they
// begin.
struct ArmBeforeFace {
  Volume<float> grey{test::grid({40, 60, 40})}, u{grey.geometry};
  ScanFrame frame;

  ArmBeforeFace() {
    for (int k = 0; k < 40; ++k)
      for (int j = 0; j < 60; ++j)
        for (int i = 0; i < 40; ++i) {
          const bool tissue = (j >= 10 && j <= 14) || j >= 20;
          grey.at(i, j, k) = tissue ? 0.9f : j > 14 ? 0.35f : 0.05f;
          u.at(i, j, k) = j == 10 || j == 20 ? 0.9f : 0.01f;
        }
  }
  void eraseArm(int fromI, int toI) {
    auto erased = std::make_shared<Volume<std::uint8_t>>(grey.geometry);
    for (int k = 0; k < 40; ++k)
      for (int j = 5; j < 17; ++j)
        for (int i = fromI; i < toI; ++i) erased->at(i, j, k) = 1;
    frame.region.erased = erased;
  }
  FoundSurface find(bool offset = false) const {
    SurfaceOptions options;
    options.offsetCorrection = offset;
    return findSurface({grey, u, grey, frame, 0.5}, options);
  }
  static std::size_t at(const FoundSurface& found, int j) {
    return std::size_t(std::count_if(found.voxels.begin(), found.voxels.end(),
                                     [j](const SurfaceVoxel& v) { return v.voxel.y == j; }));
  }
};

constexpr std::size_t kSheet = 38 * 38;  // a layer without the volume's outermost voxels

TEST(FindSurface, AnArmHidesTheFace) {
  const FoundSurface found = ArmBeforeFace().find();
  EXPECT_EQ(ArmBeforeFace::at(found, 10), kSheet);
  EXPECT_EQ(found.voxels.size(), kSheet);
}

TEST(FindSurface, AnErasedArmLetsTheFaceBeFound) {
  ArmBeforeFace scene;
  scene.eraseArm(0, 40);
  const FoundSurface found = scene.find();
  EXPECT_EQ(ArmBeforeFace::at(found, 20), kSheet);
  EXPECT_EQ(found.voxels.size(), kSheet);
  EXPECT_EQ(found.points.size(), kSheet);
}

TEST(FindSurface, HalfAnArmHidesHalfTheFace) {
  ArmBeforeFace scene;
  scene.eraseArm(20, 40);
  const FoundSurface found = scene.find();
  EXPECT_EQ(ArmBeforeFace::at(found, 10), kSheet / 2);
  EXPECT_EQ(ArmBeforeFace::at(found, 20), kSheet / 2);
  for (const SurfaceVoxel& v : found.voxels) EXPECT_EQ(v.voxel.y, v.voxel.x < 20 ? 10 : 20);
}

// What is cut away is gone, and what stays does not move.
TEST(FindSurface, ACutMovesNothingThatStays) {
  ArmBeforeFace scene;
  const FoundSurface whole = scene.find();
  scene.frame.region.first = {5, 0, 0};
  scene.frame.region.last = {39, 59, 30};
  const FoundSurface part = scene.find();
  ASSERT_EQ(part.voxels.size(), 34u * 30u);
  std::size_t n = 0;
  for (const SurfaceVoxel& v : whole.voxels) {
    if (!scene.frame.region.contains(v.voxel)) continue;
    ASSERT_EQ(part.voxels[n].voxel, v.voxel);
    EXPECT_EQ(part.voxels[n++].position, v.position);
  }
}

// The edge is measured at the points that are left: here the face's echo rises slower than the arm's.
TEST(FindSurface, TheEdgeIsThatOfThePointsThatAreLeft) {
  ArmBeforeFace scene;
  for (int k = 0; k < 40; ++k)
    for (int j = 20; j < 26; ++j)
      for (int i = 0; i < 40; ++i) scene.grey.at(i, j, k) = 0.4f + 0.1f * float(j - 20);
  const double arm = scene.find(true).edge.width;
  scene.eraseArm(0, 40);
  const double face = scene.find(true).edge.width;
  EXPECT_GT(arm, 0);
  EXPECT_GT(face, arm + 1);
}

}  // namespace
}  // namespace sonoskin
