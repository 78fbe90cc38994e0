#include "core/mesh/repair/fill_holes.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/base/error.h"
#include "core/mesh/components.h"
#include "core/mesh/facts/mesh_check.h"
#include "core/mesh/half_edges.h"
#include "core/mesh/search/self_intersections.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

// A sphere without what lies above z = height; triangles with one corner above are gone too.
Mesh withoutCap(int level, float radius, float height) {
  Mesh mesh = test::icosphere(level, radius, {});
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.positions[v].z > height; });
  });
  compactVertices(mesh);
  return mesh;
}

std::size_t borderEdges(const Mesh& mesh) { return checkMesh(mesh).boundaryEdges; }

TEST(FillHoles, CapOfASphereComesBack) {
  const Mesh open = withoutCap(5, 10, 8.66f);  // 30 degrees around the pole, 10 mm across
  ASSERT_GT(borderEdges(open), 40u);
  const Mesh filled = fillHoles(open, {12, Outline::fill});
  const MeshCheck check = checkMesh(filled);
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_EQ(check.euler, 2);
  EXPECT_EQ(check.degenerateTriangles, 0u);
  EXPECT_EQ(countSelfIntersections(filled), 0u);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(surfaceArea(filled), 4 * pi * 100, 0.01 * 4 * pi * 100);
  EXPECT_NEAR(enclosedVolume(filled), 4 * pi / 3 * 1000, 0.01 * 4 * pi / 3 * 1000);
  // The cap itself: its points lie on the sphere, and are as many as were taken out.
  double worst = 0;
  for (std::size_t v = open.positions.size(); v < filled.positions.size(); ++v)
    worst = std::max(worst, std::abs(double(glm::length(filled.positions[v])) - 10));
  EXPECT_LT(worst, 0.12);
  const double missing = 10242 - double(open.positions.size());
  EXPECT_NEAR(double(filled.positions.size() - open.positions.size()) / missing, 1, 0.3);
}

TEST(FillHoles, LargerHolesAndOuterBordersStay) {
  const Mesh open = withoutCap(4, 10, 8.66f);
  const Mesh same = fillHoles(open, {9, Outline::fill});
  EXPECT_EQ(same.triangles, open.triangles);
  EXPECT_EQ(fillHoles(open, {1e9, Outline::keep}).triangles,
            open.triangles);  // its only border is the outer one
}

TEST(FillHoles, OfTwoBordersTheOuterOneStays) {
  Mesh bowl = withoutCap(4, 10, 0);
  std::erase_if(bowl.triangles, [&](const Triangle& t) { return bowl.positions[t[0]].z < -9; });
  compactVertices(bowl);
  const std::size_t before = borderEdges(bowl);
  const Mesh filled = fillHoles(bowl, {std::numeric_limits<double>::infinity(), Outline::keep});
  EXPECT_LT(borderEdges(filled), before);
  EXPECT_GT(borderEdges(filled), 20u);
  EXPECT_EQ(checkMesh(filled).euler, 1);  // a disc
}

TEST(FillHoles, SingleTrianglesAndOddLoops) {
  Mesh mesh = test::icosphere(3, 10, {});
  // One triangle, two neighbours, a fan around a vertex.
  std::erase_if(mesh.triangles, [&, n = 0](const Triangle& t) mutable {
    const int i = n++;
    return i == 5 || i == 400 || i == 401 || t[0] == 100 || t[1] == 100 || t[2] == 100;
  });
  compactVertices(mesh);
  const Mesh filled = fillHoles(mesh, {10, Outline::fill});
  const MeshCheck check = checkMesh(filled);
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_EQ(check.euler, 2);
}

TEST(FillHoles, PartsOfTheMeshStayAndNewOnesAreComplete) {
  Mesh open = withoutCap(4, 10, 8.66f);
  open.visibility.assign(open.positions.size(), 1.f);
  open.labels.assign(open.positions.size(), 3);
  const Mesh filled = fillHoles(open, {12, Outline::fill});
  ASSERT_EQ(filled.normals.size(), filled.positions.size());
  ASSERT_EQ(filled.visibility.size(), filled.positions.size());
  ASSERT_EQ(filled.labels.size(), filled.positions.size());
  EXPECT_EQ(filled.labels[0], 3);
  EXPECT_TRUE(std::equal(open.positions.begin(), open.positions.end(), filled.positions.begin()));
  EXPECT_TRUE(std::equal(open.normals.begin(), open.normals.end(), filled.normals.begin()));
  for (std::size_t v = open.positions.size(); v < filled.positions.size(); ++v) {
    EXPECT_EQ(filled.visibility[v], 0);
    EXPECT_EQ(filled.labels[v], 0);
    EXPECT_GT(glm::dot(filled.normals[v], glm::normalize(filled.positions[v])), 0.98f);
  }
}

TEST(FillHoles, LongRaggedLoopsAreCut) {
  // A flat ring whose inner border is a star of 720 points.
  Mesh ring;
  constexpr int n = 720;
  for (int i = 0; i < n; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * float(i) / n;
    const glm::vec3 out(std::cos(angle), std::sin(angle), 0);
    ring.positions.push_back((20 + 3 * std::sin(12 * angle)) * out);
    ring.positions.push_back(30.f * out);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
    ring.triangles.insert(ring.triangles.end(), {{a, a + 1, b + 1}, {a, b + 1, b}});
  }
  const Mesh filled = fillHoles(ring, {50, Outline::keep});
  EXPECT_EQ(borderEdges(filled), std::size_t(n));
  EXPECT_NEAR(surfaceArea(filled), surfaceArea(ring) + std::numbers::pi * (400 + 4.5), 5);
  EXPECT_TRUE(checkMesh(filled).manifold());
  EXPECT_EQ(countSelfIntersections(filled), 0u);
}

TEST(FillHoles, Cancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(fillHoles(withoutCap(4, 10, 8.66f), {12, Outline::fill}, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
