#include "core/surface/thesis_thinning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/base/error.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

SurfaceOptions everywhere() {
  SurfaceOptions o;
  o.thinning = ThinningMethod::thesis;
  o.facing = -1;
  o.borderMargin = 0;
  o.threshold = 0.15;
  return o;
}

// A ridge of u along the plane x = 12 and its edge.
Volume<float> ridge(const Geometry& g) {
  return test::fill(g, [](glm::dvec3 p) { return 1 / (1 + (p.x - 12) * (p.x - 12) / 4); });
}

TEST(ThesisThinning, EveryDirectionIsItsOwnNearest) {
  std::set<std::array<int, 3>> found;
  for (int n = 0; n < 27; ++n) {
    const glm::ivec3 d(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    if (d == glm::ivec3(0)) continue;
    const glm::ivec3 nearest = nearestOf13(0.01f * glm::vec3(d));
    EXPECT_TRUE(nearest == d || nearest == -d) << n;
    found.insert({nearest.x, nearest.y, nearest.z});
  }
  EXPECT_EQ(found.size(), 13u);
}

TEST(ThesisThinning, NearestIsByAngle) {
  EXPECT_EQ(nearestOf13({1, 0.4f, 0}), glm::ivec3(1, 0, 0));  // 21.8 degrees from x, 23.2 from xy
  EXPECT_EQ(nearestOf13({1, 0.42f, 0}), glm::ivec3(1, 1, 0));
  EXPECT_EQ(nearestOf13({-0.5f, 0.6f, 0.55f}), -glm::ivec3(-1, 1, 1));
}

TEST(ThesisThinning, ARidgeBecomesOneSheetOfWholeVoxels) {
  const Geometry g = test::grid({25, 9, 8}, {1, 1, 1});
  Volume<float> u = ridge(g);
  // A slope along the ridge gives its top a direction: without one the gradient is zero there.
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) u.at(i, j, k) *= float(1 + 0.002 * i);
  const auto found = thinByThesis(u, u, {}, everywhere());
  EXPECT_EQ(found.size(), std::size_t(7 * 6));
  for (const auto& s : found) {
    EXPECT_EQ(s.voxel.x, 12);
    EXPECT_EQ(s.position, glm::vec3(s.voxel));
    const float mean = (u.at(11, 3, 3) + u.at(12, 3, 3) + u.at(13, 3, 3)) / 3;
    EXPECT_NEAR(s.value, mean, 1e-6);  // of the blurred u
  }
}

TEST(ThesisThinning, ThresholdCountsForTheBlurredValue) {
  Volume<float> u(test::grid({9, 9, 9}), 0.0f);
  u.at(4, 4, 4) = 1;  // blurred: 1/27
  auto o = everywhere();
  o.threshold = 0.04;
  EXPECT_TRUE(thinByThesis(u, u, {}, o).empty());
}

TEST(ThesisThinning, FacingAndBorderAreThoseOfTheOtherThinning) {
  const Geometry g = test::grid({40, 40, 40});
  const glm::dvec3 centre(19.6);
  const auto u = test::fill(g, [&](glm::dvec3 p) {
    const double d = glm::length(p - centre) - 12;
    return 1 / (1 + d * d / 4);
  });
  const auto v =
      test::fill(g, [&](glm::dvec3 p) { return 0.5 * (1 - std::tanh((glm::length(p - centre) - 12) / 3)); });
  const std::size_t all = thinByThesis(u, v, {}, everywhere()).size();
  EXPECT_GT(all, 1000u);
  auto o = everywhere();
  o.facing = 0.1;
  ScanFrame frame;
  frame.beam.axis = {0, 1, 0};
  const auto facing = thinByThesis(u, v, frame, o);
  EXPECT_GT(facing.size(), all / 4);
  for (const auto& s : facing) EXPECT_LT(s.voxel.y, 20);
  o = everywhere();
  o.borderMargin = 3;
  frame.view.sides = {glm::vec4(1, 0, 0, -25)};
  const auto within = thinByThesis(u, v, frame, o);
  EXPECT_GT(within.size(), facing.size() / 4);
  for (const auto& s : within) EXPECT_LE(s.voxel.x, 22);
}

TEST(ThesisThinning, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  const Volume<float> u(test::grid({5, 5, 5}));
  EXPECT_THROW(thinByThesis(u, u, {}, everywhere(), Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
