#include "core/mesh/search/point_grid.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

std::vector<glm::vec3> randomPoints(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-5, 5);
  std::vector<glm::vec3> points(count);
  for (glm::vec3& p : points) p = {400 + 2 * uniform(random), uniform(random), uniform(random)};
  return points;
}

TEST(PointGrid, HoldsEveryPointOnce) {
  const auto points = randomPoints(1000, 1);
  const PointGrid grid(points, 0.7f);
  EXPECT_EQ(std::set<std::uint32_t>(grid.order().begin(), grid.order().end()).size(), points.size());
  EXPECT_EQ(grid.order().size(), points.size());
}

TEST(PointGrid, RadiusQueriesEqualBruteForce) {
  const auto points = randomPoints(2000, 2);
  const PointGrid grid(points, 0.7f);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> size(0, 6);
  for (const glm::vec3& offset : randomPoints(200, 4)) {
    const glm::vec3 centre =
        1.2f * (offset - glm::vec3(400, 0, 0)) + glm::vec3(400, 0, 0);  // some lie outside
    const float radius = size(random);
    std::set<std::uint32_t> expected, found;
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (glm::distance(points[i], centre) < radius) expected.insert(i);
    std::size_t visited = 0;
    grid.forEachRun(centre, radius, [&](std::size_t first, std::size_t last) {
      visited += last - first;
      for (std::size_t s = first; s < last; ++s)
        if (glm::distance(points[grid.order()[s]], centre) < radius) found.insert(grid.order()[s]);
    });
    EXPECT_EQ(found, expected);
    EXPECT_LT(double(visited),
              8 * std::pow(double(radius) + 0.7, 3) * 2000 / 2000 * 1.5 + 20);  // not all of them
  }
}

TEST(PointGrid, MeasuresTheSpacing) {
  EXPECT_NEAR(pointSpacing(planePoints(100).positions), 1, 0.15);
  EXPECT_NEAR(pointSpacing(spherePoints(20000, 40).positions), 1, 0.15);
  EXPECT_NEAR(pointSpacing(spherePoints(500, 40).positions), std::sqrt(4 * M_PI * 1600 / 500), 1.5);
  EXPECT_EQ(pointSpacing(std::vector<glm::vec3>(20, {1, 2, 3})), 0);
}

}  // namespace
}  // namespace sonoskin
