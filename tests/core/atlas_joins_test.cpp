#include "core/mesh/atlas_joins.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin {
namespace {

// A band of 160 steps along `shape`, two charts of it along the front's axis, and the limits under which they are joined.
template <class Shape>
std::size_t chartsLeft(const Shape& shape, const JoinLimits& limits) {
  Mesh mesh;
  for (int i = 0; i <= 160; ++i)
    for (const float side : {0.f, 10.f}) mesh.positions.push_back(shape(0.08f * float(i), side));
  for (std::uint32_t i = 0; i < 320; i += 2) {
    mesh.triangles.push_back({i, i + 1, i + 3});
    mesh.triangles.push_back({i, i + 3, i + 2});
  }
  const Facets facets(mesh);
  std::vector<glm::vec3> normals;
  for (const glm::vec3& n : facets.normal) normals.push_back(n / glm::length(n));
  const auto axes = chartAxes(normals[0]);
  Charts charts{std::vector<std::uint32_t>(320, 0), {0, 0}};
  for (std::size_t t = 180; t < 320; ++t) charts.ofTriangle[t] = 1;
  joinCharts(facets, normals, axes, limits, charts);
  EXPECT_EQ(charts.ofTriangle[0], 0u);
  EXPECT_EQ(charts.ofTriangle[319], std::uint32_t(charts.size() - 1));
  return charts.size();
}

glm::vec3 flat(float way, float side) { return {4 * way, side, 0}; }
// Winds once around and then lies 3 mm over itself.
glm::vec3 stairs(float way, float side) {
  return {(5 + side) * std::cos(way), (5 + side) * std::sin(way), 0.5f * way};
}
// Bends away from the front by 115 degrees.
glm::vec3 bent(float way, float side) { return {10 * std::sin(way / 6.4f), side, 10 * std::cos(way / 6.4f)}; }

TEST(AtlasJoins, SmallChartsJoinThoseBesideThem) {
  EXPECT_EQ(chartsLeft(flat, {1000, 0.02, 1}), 1u);
  EXPECT_EQ(chartsLeft(flat, {100, 0.02, 1}), 2u) << "Large ones stay.";
}

TEST(AtlasJoins, NotWhereTheyWouldLieOverThem) {
  EXPECT_EQ(chartsLeft(stairs, {10000, 0.02, 10000}), 2u);
  EXPECT_EQ(chartsLeft(stairs, {10000, 1, 1}), 2u);
  EXPECT_EQ(chartsLeft(stairs, {10000, 1, 10000}), 1u);
}

TEST(AtlasJoins, NotWhereTheyWouldBeTurnedAway) { EXPECT_EQ(chartsLeft(bent, {100, 1, 10000}), 2u); }

}  // namespace
}  // namespace sonoskin
