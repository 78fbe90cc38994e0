#include "core/mesh/search/self_intersections.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/components.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

// The segment p + s (q - p) meets the triangle's plane at s in (0, 1), inside it by barycentric coordinates. A
// twin that shares nothing with the counter.
bool segmentMeets(const glm::dvec3& p, const glm::dvec3& q, const Corners& t) {
  const glm::dmat3 system(t[1] - t[0], t[2] - t[0], p - q);
  if (std::abs(glm::determinant(system)) < 1e-12) return false;
  const glm::dvec3 x = glm::inverse(system) * (p - t[0]);
  return x.x >= 0 && x.y >= 0 && x.x + x.y <= 1 && x.z > 0 && x.z < 1;
}

std::size_t countAllPairs(const Mesh& mesh) {
  const auto corners = [&](std::size_t t) {
    const Triangle& c = mesh.triangles[t];
    return Corners{glm::dvec3(mesh.positions[c[0]]), glm::dvec3(mesh.positions[c[1]]),
                   glm::dvec3(mesh.positions[c[2]])};
  };
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t u = t + 1; u < mesh.triangles.size(); ++u) {
      int common = 0;
      for (const auto v : mesh.triangles[t])
        common += int(std::count(mesh.triangles[u].begin(), mesh.triangles[u].end(), v));
      if (common > 0) continue;  // the twin's meshes cross in triangles without a common corner only
      const Corners a = corners(t), b = corners(u);
      bool crosses = false;
      for (std::size_t i = 0; i < 3; ++i)
        crosses = crosses || segmentMeets(a[i], a[(i + 1) % 3], b) || segmentMeets(b[i], b[(i + 1) % 3], a);
      count += crosses;
    }
  return count;
}

TEST(SelfIntersections, NoneInASphere) {
  EXPECT_EQ(countSelfIntersections(test::icosphere(4, 10, {1, 2, 3})), 0u);
}

TEST(SelfIntersections, CrossingSpheresAsAllPairs) {
  const Mesh both =
      joinPieces({test::icosphere(3, 10, {1, 2, 3}), test::icosphere(3, 7, {9.3f, 4.1f, 2.2f})});
  const std::size_t count = countSelfIntersections(both);
  EXPECT_GT(count, 50u);
  EXPECT_EQ(count, countAllPairs(both));
}

TEST(SelfIntersections, NeighboursAtACorner) {
  const glm::dvec3 o(0), x(1, 0, 0), y(0, 1, 0);
  EXPECT_FALSE(trianglesCross({o, x, y}, {o, -x, -y}));
  EXPECT_TRUE(trianglesCross({o, x, y}, {o, {0.4, 0.2, 1}, {0.2, 0.4, -1}}));
  EXPECT_FALSE(trianglesCross({o, x, y}, {o, {-0.4, 0.2, 1}, {-0.2, -0.4, -1}}));
  EXPECT_FALSE(trianglesCross({o, x, y}, {o, x, {0.2, 0.4, -1}}));  // a common side
  EXPECT_FALSE(
      trianglesCross({o, x, y}, Corners{{{0.1, 0.1, 0}, {0.5, 0.1, 0}, {0.1, 0.5, 0}}}));  // one plane
}

// Flat strips of triangles whose coordinates are rounded touch, but nothing crosses.
TEST(SelfIntersections, NoneInAnInclinedPlane) {
  Mesh mesh;
  for (int j = 0; j < 60; ++j)
    for (int i = 0; i < 60; ++i) {
      const float x = 0.13f * float(i), y = 0.26f * float(j);
      mesh.positions.push_back({9.88f + 0.12f * x, y, 0.7f - 0.12f * x + 0.3f * y});
      if (i == 0 || j == 0) continue;
      const auto v = std::uint32_t(60 * j + i);
      mesh.triangles.insert(mesh.triangles.end(), {{v - 61, v - 60, v}, {v - 61, v, v - 1}});
    }
  EXPECT_EQ(countSelfIntersections(mesh), 0u);
  EXPECT_FALSE(trianglesCross({glm::dvec3(10, 2.5999999, -0.119999997),
                               {9.88000011, 2.5999999, -6.13928108e-08},
                               {9.88000011, 2.33999991, -6.13928108e-08}},
                              {glm::dvec3(10, 2.07999992, -0.119999997),
                               {9.88000011, 2.07999992, -6.13928108e-08},
                               {9.88000011, 1.82000005, -6.13928108e-08}}));
}

// Copies of corners instead of common vertices change nothing: what an STL file gives.
TEST(SelfIntersections, SoupOfTriangles) {
  const Mesh sphere = test::icosphere(2, 10, {0.1f, 0.2f, 0.3f});
  Mesh soup;
  for (const Triangle& t : sphere.triangles) {
    const auto first = std::uint32_t(soup.positions.size());
    for (const auto v : t) soup.positions.push_back(sphere.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(countSelfIntersections(soup), 0u);
}

TEST(SelfIntersections, SameOnAnyNumberOfThreadsAndCancelled) {
  const Mesh both = joinPieces({test::icosphere(5, 10, {}), test::icosphere(5, 7, {8.f, 1.f, 2.f})});
  setThreadCount(1);
  const std::size_t one = countSelfIntersections(both);
  setThreadCount(2);
  EXPECT_EQ(countSelfIntersections(both), one);
  setThreadCount(0);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(countSelfIntersections(both, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
