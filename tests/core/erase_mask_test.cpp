#include "core/volume/erase_mask.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/test_volumes.h"
#include "tests/support/volumes.h"

namespace sonoskin {
namespace {

// A grid that is turned and whose voxels are no cubes.
Geometry turnedGrid() {
  Geometry g = test::turnedGeometry(true);
  g.dims = {23, 19, 14};
  return g;
}

std::size_t count(const VoxelRuns& runs) {
  std::size_t sum = 0;
  for (const VoxelRun& run : runs) sum += run.count;
  return sum;
}

double distanceToLine(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  double least = 1e9;
  for (int step = 0; step <= 2000; ++step)
    least = std::min(least, glm::distance(p, glm::mix(a, b, step / 2000.0)));
  return least;
}

TEST(EraseMask, ABallErasesExactlyTheVoxelsWithinItsRadius) {
  const Geometry g = turnedGrid();
  const glm::dvec3 centre = g.toWorld({9.3, 8.1, 6.6});
  Volume<std::uint8_t> mask(g);
  const VoxelRuns runs = paint(mask, {centre, centre, 2.6, true});
  std::size_t marked = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        EXPECT_EQ(mask.at(i, j, k) != 0, glm::distance(g.toWorld({i, j, k}), centre) <= 2.6);
        marked += mask.at(i, j, k);
      }
  EXPECT_GT(marked, 100u);
  EXPECT_EQ(count(runs), marked);
}

TEST(EraseMask, AStrokeLeavesNoGaps) {
  const Geometry g = turnedGrid();
  const glm::dvec3 from = g.toWorld({3, 4, 3}), to = g.toWorld({18.5, 14.2, 10});
  Volume<std::uint8_t> mask(g);
  paint(mask, {from, to, 1.5, true});
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const double distance = distanceToLine(g.toWorld({i, j, k}), from, to);
        if (std::abs(distance - 1.5) < 1e-3) continue;  // too near to tell
        EXPECT_EQ(mask.at(i, j, k) != 0, distance < 1.5);
      }
}

TEST(EraseMask, BringsBackAndUndoes) {
  const Geometry g = turnedGrid();
  const glm::dvec3 a = g.toWorld({8, 8, 6}), b = g.toWorld({11, 9, 7});
  Volume<std::uint8_t> mask(g);
  paint(mask, {a, a, 3, true});
  const auto before = mask.data;
  EXPECT_TRUE(paint(mask, {a, a, 2, true}).empty()) << "nothing is erased twice";
  const VoxelRuns back = paint(mask, {b, b, 2, false});
  EXPECT_FALSE(back.empty());
  const auto after = mask.data;
  EXPECT_NE(after, before);
  toggle(mask, back);
  EXPECT_EQ(mask.data, before);
  toggle(mask, back);
  EXPECT_EQ(mask.data, after);
}

TEST(EraseMask, ATinyBrushStillErasesTheVoxelUnderIt) {
  Volume<std::uint8_t> mask(turnedGrid());
  const glm::dvec3 at = mask.geometry.toWorld({4.4, 5.4, 6.4});
  EXPECT_EQ(count(paint(mask, {at, at, 0.01, true})), 1u);
  EXPECT_EQ(mask.at(4, 5, 6), 1);
}

TEST(EraseMask, BesideTheVolumeNothingIsErased) {
  Volume<std::uint8_t> mask(turnedGrid());
  for (const glm::dvec3 index : {glm::dvec3(-40, 5, 5), glm::dvec3(5, 90, 5), glm::dvec3(5, 5, 60)}) {
    const glm::dvec3 at = mask.geometry.toWorld(index);
    EXPECT_TRUE(paint(mask, {at, at, 2, true}).empty());
  }
}

TEST(EraseMask, DifferencesLeadFromOneMaskToTheOther) {
  Volume<std::uint8_t> a(turnedGrid()), b(turnedGrid());
  const glm::dvec3 p = a.geometry.toWorld({8, 8, 6}), q = a.geometry.toWorld({12, 9, 8});
  paint(a, {p, p, 3, true});
  paint(b, {q, q, 3, true});
  for (auto& v : b.data) v = v ? 255 : 0;  // any value but zero counts
  Volume<std::uint8_t> changed = a;
  toggle(changed, differences(a, b));
  EXPECT_TRUE(differences(changed, b).empty());
  EXPECT_FALSE(differences(changed, a).empty());
}

TEST(EraseMask, RunLengthsAreTheMask) {
  const Geometry g = turnedGrid();
  for (const bool marksFirst : {false, true}) {
    Volume<std::uint8_t> mask(g);
    for (std::size_t v = 0; v < mask.data.size(); ++v) mask.data[v] = (v * v) % 7 < 3;
    mask.data.front() = marksFirst;
    const RunLengths runs = runLengths(mask);
    EXPECT_EQ(runs.counts.front() == 0, marksFirst);
    EXPECT_EQ(fromRunLengths(runs, g).data, mask.data);
  }
  EXPECT_EQ(runLengths(Volume<std::uint8_t>(g)).counts, std::vector<std::size_t>{g.voxels()});
}

TEST(EraseMask, RunLengthsOfOtherVolumesAreRefused) {
  const Geometry g = turnedGrid();
  EXPECT_THROW(fromRunLengths({g.dims + 1, {g.voxels()}}, g), Error);
  EXPECT_THROW(fromRunLengths({g.dims, {g.voxels() - 1}}, g), Error);
  EXPECT_THROW(fromRunLengths({g.dims, {1, g.voxels()}}, g), Error);
  EXPECT_THROW(fromRunLengths({g.dims, {1, ~std::size_t(0)}}, g), Error);
}

}  // namespace
}  // namespace sonoskin
