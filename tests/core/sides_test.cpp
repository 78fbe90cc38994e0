#include "core/surface/sides.h"

#include <gtest/gtest.h>

#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// A line of voxels along i at (., 10, 10): those below `kept` face the probe, the others do not.
std::vector<SurfaceVoxel> line(int from, int to) {
  std::vector<SurfaceVoxel> voxels;
  for (int i = from; i < to; ++i) voxels.push_back({{i, 10, 10}, glm::vec3(i, 10, 10), 0.5f, 0.f});
  return voxels;
}

TEST(GrowSides, FollowsTheSurfaceAsFarAsItMay) {
  const Geometry geometry = test::grid({40, 20, 20}, {0.5, 0.5, 1});
  const auto grown = growSides(line(1, 10), line(10, 30), geometry, 3);
  ASSERT_EQ(grown.size(), 9u + 6u);  // 3 mm are six voxels
  for (std::size_t v = 0; v < grown.size(); ++v) EXPECT_EQ(grown[v].voxel.x, int(v) + 1);
}

TEST(GrowSides, DoesNotLeapOverGaps) {
  const Geometry geometry = test::grid({40, 20, 20});
  EXPECT_EQ(growSides(line(1, 10), line(12, 20), geometry, 10).size(), 9u);
  EXPECT_EQ(growSides({}, line(12, 20), geometry, 10).size(), 0u);
}

TEST(GrowSides, AddsNothingWithoutReach) {
  EXPECT_EQ(growSides(line(1, 10), line(10, 20), test::grid({40, 20, 20}), 0).size(), 9u);
}

// Ways are measured along the voxels, with diagonal steps as long as they are.
TEST(GrowSides, MeasuresDiagonalSteps) {
  const Geometry geometry = test::grid({40, 40, 20}, {1, 1, 1});
  std::vector<SurfaceVoxel> diagonal;
  for (int n = 1; n < 10; ++n)
    diagonal.push_back({{10 + n, 10 + n, 10}, glm::vec3(10 + n, 10 + n, 10), 0.5f, 0.f});
  const std::vector<SurfaceVoxel> start{{{10, 10, 10}, glm::vec3(10), 0.5f, 1.f}};
  EXPECT_EQ(growSides(start, diagonal, geometry, 4.3).size(), 1u + 3u);  // three times the root of 2 is 4.24
}

// A voxel with a normal that looks along the beam or against it.
SurfaceVoxel turned(glm::ivec3 at, float facing) { return {at, glm::vec3(at), 0.5f, facing}; }

// The beams go along +y. Seen: a finger's front and its underside; a jaw's inside with nothing before it; a flank.
TEST(DropBareSides, TakesOutInsidesThatTheProbeWouldSee) {
  const Geometry geometry = test::grid({40, 60, 20}, {0.5, 0.5, 1});
  const Beam beam{{}, {0, 1, 0}, {0, 0, 1}};
  const SurfaceVoxel front = turned({10, 10, 10}, 0.9f), underside = turned({10, 20, 10}, -0.5f),
                     beside = turned({12, 20, 10}, -0.5f),  // within two voxels of what lies behind the front
      bare = turned({30, 20, 10}, -0.5f), flank = turned({31, 10, 10}, -0.1f),
                     hiddenByABack = turned({30, 40, 10}, -0.5f);
  const auto kept = dropBareSides({front, flank, underside, beside, bare, hiddenByABack}, geometry, beam);
  ASSERT_EQ(kept.size(), 4u);
  EXPECT_EQ(kept[1].voxel, flank.voxel);
  EXPECT_EQ(kept[2].voxel, underside.voxel);
  EXPECT_EQ(kept[3].voxel, beside.voxel);
}

TEST(DropBareSides, LooksBackAlongTheBeamsOfAnApex) {
  const Geometry geometry = test::grid({60, 60, 20});
  const SurfaceVoxel front = turned({20, 20, 10}, 0.9f), behind = turned({40, 40, 10}, -0.5f),
                     below = turned({20, 40, 10}, -0.5f);
  const Beam beam{glm::dvec3(0, 0, 10), {0, 1, 0}, {0, 0, 1}};
  const auto kept = dropBareSides({front, behind, below}, geometry, beam);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[1].voxel, behind.voxel);
}

}  // namespace
}  // namespace sonoskin
