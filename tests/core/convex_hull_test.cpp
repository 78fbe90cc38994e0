#include "core/volume/convex_hull.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

TEST(ConvexHull, OfABoxHasItsSixFaces) {
  std::vector<glm::dvec3> points;
  for (int n = 0; n < 500; ++n)
    points.emplace_back(3 * test::noise(std::uint64_t(n)), 4 * test::noise(std::uint64_t(n) + 1000),
                        5 * test::noise(std::uint64_t(n) + 2000));
  for (int corner = 0; corner < 8; ++corner)
    points.emplace_back(corner & 1 ? 3 : 0, corner & 2 ? 4 : 0, corner & 4 ? 5 : 0);
  const auto faces = convexHull(points, 0.05);
  ASSERT_EQ(faces.size(), 6u);
  EXPECT_NEAR(faces[0].area, 20, 1e-9);
  EXPECT_NEAR(std::abs(faces[0].normal.x), 1, 1e-9);
  EXPECT_NEAR(std::accumulate(faces.begin(), faces.end(), 0.0, [](double a, auto& f) { return a + f.area; }),
              94, 1e-9);
  for (const HullFace& f : faces)
    for (const glm::dvec3& p : points) EXPECT_LE(glm::dot(f.normal, p) + f.offset, 1e-9);
}

// Merged or not, no plane cuts the body, and on a ball it leaves off no more than the merging allows.
TEST(ConvexHull, MergedFacesTouchTheBodyFromOutside) {
  std::vector<glm::dvec3> points;
  for (int n = 0; n < 3000; ++n) {
    const double z = 2 * test::noise(std::uint64_t(n)) - 1,
                 phi = 6.2831853 * test::noise(std::uint64_t(n) + 9999);
    points.emplace_back(10 * std::sqrt(1 - z * z) * std::cos(phi), 10 * std::sqrt(1 - z * z) * std::sin(phi),
                        10 * z);
  }
  const std::size_t all = convexHull(points, 0).size();
  const auto faces = convexHull(points, 0.15);
  EXPECT_LT(faces.size(), all / 4);
  double most = -1;
  for (const HullFace& f : faces) {
    EXPECT_NEAR(f.offset, -10, 0.1);
    for (const glm::dvec3& p : points) most = std::max(most, glm::dot(f.normal, p) + f.offset);
  }
  EXPECT_NEAR(most, 0, 1e-9);
}

TEST(ConvexHull, OutlineOfARectangle) {
  std::vector<glm::dvec2> points{{0, 0}, {4, 0}, {4, 2}, {0, 2}, {1, 1}, {2, 0}, {4, 1}, {0, 0}};
  const auto edges = convexOutline(points, 0.05);
  ASSERT_EQ(edges.size(), 4u);
  EXPECT_NEAR(edges[0].length, 4, 1e-12);
  for (const HullEdge& e : edges)
    for (const glm::dvec2& p : points) EXPECT_LE(glm::dot(e.normal, p) + e.offset, 1e-12);
}

TEST(ConvexHull, OfNothingOrAFlatThingIsEmpty) {
  EXPECT_TRUE(convexHull({}, 0.05).empty());
  EXPECT_TRUE(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 2, 0}}, 0.05).empty());
  EXPECT_TRUE(convexOutline({}, 0.05).empty());
  EXPECT_TRUE(convexOutline({{1, 1}, {1, 1}, {1, 1}}, 0.05).empty());
  EXPECT_TRUE(convexOutline({{0, 0}, {1, 1}, {2, 2}}, 0.05).empty());
}

}  // namespace
}  // namespace sonoskin
