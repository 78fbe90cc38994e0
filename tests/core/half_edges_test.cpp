#include "core/mesh/half_edges.h"

#include <gtest/gtest.h>

#include "core/mesh/facts/mesh_check.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

TEST(HalfEdges, EverySideOfASphereHasItsOpposite) {
  const Mesh sphere = test::icosphere(2, 1, {});
  const auto opposite = oppositeHalfEdges(sphere.triangles, sphere.positions.size());
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    ASSERT_NE(opposite[h], kNoHalfEdge);
    EXPECT_EQ(opposite[opposite[h]], h);
    EXPECT_EQ(originOf(sphere.triangles, opposite[h]), originOf(sphere.triangles, nextHalfEdge(h)));
  }
  EXPECT_TRUE(borderLoops(sphere.triangles, opposite).empty());
}

TEST(HalfEdges, BordersRunWithTheSurfaceOnTheirLeft) {
  Mesh square;  // counter-clockwise, normal +z
  square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto loops = borderLoops(square.triangles, oppositeHalfEdges(square.triangles, 4));
  ASSERT_EQ(loops.size(), 1u);
  std::vector<std::uint32_t> vertices;
  for (const auto h : loops[0]) vertices.push_back(originOf(square.triangles, h));
  EXPECT_EQ(vertices, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(HalfEdges, SurfacesThatTouchComeApart) {
  Mesh mesh;  // two triangles that touch in a corner, and three on one edge
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0},
                    {0, 0, 5}, {0, 0, 6}, {1, 0, 5}, {0, 1, 5},  {0, -1, 5}};
  mesh.normals.assign(10, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}, {5, 6, 7}, {5, 6, 8}, {6, 5, 9}};
  EXPECT_FALSE(checkMesh(mesh).manifold());
  splitFans(mesh);
  EXPECT_TRUE(checkMesh(mesh).manifold());
  EXPECT_EQ(mesh.positions.size(), 10u + 1 + 4);
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
}

TEST(HalfEdges, ClosedFansStayWhole) {
  Mesh sphere = test::icosphere(2, 1, {});
  splitFans(sphere);
  EXPECT_EQ(sphere.positions.size(), 162u);
  EXPECT_TRUE(checkMesh(sphere).closed());
}

TEST(HalfEdges, CompactDropsWhatNoTriangleNames) {
  Mesh mesh;
  mesh.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}};
  mesh.visibility = mesh.measured = {9, 1, 2, 8, 3};
  mesh.labels = {9, 1, 2, 8, 3};
  mesh.triangles = {{1, 2, 4}};
  compactVertices(mesh);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(mesh.visibility, (std::vector<float>{1, 2, 3}));
  EXPECT_EQ(mesh.measured, mesh.visibility);
  EXPECT_EQ(mesh.labels, (std::vector<std::uint8_t>{1, 2, 3}));
}

}  // namespace
}  // namespace sonoskin
