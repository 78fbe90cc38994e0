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

// Beside a sphere of 10 mm a hole of 5 mm is small, one of 10 mm is not: its box has a squared diagonal of 200 mm².
TEST(FillHoles, AnOutlineIsFilledWhereItIsSmallBesideItsPiece) {
  const HoleOptions unlessSmall{12, Outline::keepUnlessSmall};
  EXPECT_EQ(borderEdges(fillHoles(withoutCap(5, 10, 9.7f), unlessSmall)), 0u);
  const Mesh wide = withoutCap(5, 10, 8.66f);
  EXPECT_EQ(fillHoles(wide, unlessSmall).triangles, wide.triangles);
  // Each piece has an outline of its own.
  const Mesh both = joinPieces({withoutCap(4, 10, 9.5f), withoutCap(3, 2, 1.7f)});
  const Mesh filled = fillHoles(both, unlessSmall);
  EXPECT_EQ(borderEdges(filled), borderEdges(withoutCap(3, 2, 1.7f)));
}

// A wall through the hole, which any patch would cross.
TEST(FillHoles, WhatWouldCrossTheSurfaceStaysOpenUnlessAskedFor) {
  const Mesh open = withoutCap(4, 10, 8.66f);
  Mesh wall;
  for (const float y : {-4.f, 4.f})
    for (const float z : {7.f, 20.f}) wall.positions.emplace_back(0.013f, y, z);
  wall.triangles = {{0, 2, 1}, {1, 2, 3}};
  computeNormals(wall);
  const Mesh both = joinPieces({open, wall});
  EXPECT_EQ(fillHoles(both, {12, Outline::fill, false}).triangles.size(), both.triangles.size());
  const Mesh filled = fillHoles(both, {12, Outline::fill, true});
  EXPECT_EQ(borderEdges(filled), 4u) << "those of the wall";
  EXPECT_GT(countSelfIntersections(filled), 0u);
}

// Two spheres that face each other, cut before they meet: their caps would reach into each other, and the first wins.
TEST(FillHoles, OfTwoPatchesThatCrossOneIsLeftOut) {
  Mesh below = withoutCap(4, 10, 7), above = below;
  const std::size_t rim = borderEdges(below);
  for (glm::vec3& p : below.positions) p.z -= 9;
  for (glm::vec3& p : above.positions) p.z = 9 - p.z;
  for (Triangle& t : above.triangles) std::swap(t[1], t[2]);
  computeNormals(above);
  const Mesh both = joinPieces({below, above});
  EXPECT_EQ(borderEdges(fillHoles(both, {18, Outline::fill, true})), 0u);
  EXPECT_EQ(borderEdges(fillHoles(both, {18, Outline::fill, false})), rim);
  EXPECT_EQ(borderEdges(fillHoles(below, {18, Outline::fill, false})), 0u);
}

// Two faces of a tetrahedron: of the two chords of the hole the shorter one is there already.
TEST(FillHoles, NoEdgeIsUsedTwice) {
  Mesh mesh;
  mesh.positions = {{-1, 0, 0}, {1, 0, 0}, {0, -5, 1}, {0, 5, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  computeNormals(mesh);
  const MeshCheck check = checkMesh(fillHoles(mesh, {20, Outline::fill}));
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_EQ(check.euler, 2);
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
