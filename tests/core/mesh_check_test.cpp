#include "core/mesh/facts/mesh_check.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

TEST(MeshCheck, ATetrahedronIsClosed) {
  const MeshCheck check = checkMesh(tetrahedron());
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_EQ(check.edges, 6u);
  EXPECT_EQ(check.euler, 2);
  EXPECT_NEAR(enclosedVolume(tetrahedron()), 1.0 / 6, 1e-12);
}

TEST(MeshCheck, FindsAHole) {
  Mesh mesh = tetrahedron();
  mesh.triangles.pop_back();
  const MeshCheck check = checkMesh(mesh);
  EXPECT_EQ(check.boundaryEdges, 3u);
  EXPECT_EQ(check.euler, 1);
}

TEST(MeshCheck, FindsATurnedTriangle) {
  Mesh mesh = tetrahedron();
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  EXPECT_EQ(checkMesh(mesh).misorientedEdges, 3u);
}

TEST(MeshCheck, FindsAnEdgeOfThreeTriangles) {
  Mesh mesh = tetrahedron();
  mesh.positions.push_back({1, 1, 1});
  mesh.triangles.push_back({1, 2, 4});
  EXPECT_EQ(checkMesh(mesh).nonManifoldEdges, 1u);
}

TEST(MeshCheck, FindsTwoShellsThatTouchInOneVertex) {
  Mesh mesh = tetrahedron();
  for (int i = 1; i < 4; ++i) mesh.positions.push_back(-mesh.positions[std::size_t(i)]);
  mesh.triangles.insert(mesh.triangles.end(), {{0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}});
  const MeshCheck check = checkMesh(mesh);
  EXPECT_TRUE(check.closed());
  EXPECT_EQ(check.nonManifoldVertices, 1u);
}

TEST(MeshCheck, CountsDegenerateTriangles) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 1}, {0, 1, 3}};
  EXPECT_EQ(checkMesh(mesh).degenerateTriangles, 2u);
}

TEST(MeshCheck, RefusesAMissingVertex) {
  Mesh mesh = tetrahedron();
  mesh.triangles[2][1] = 4;
  EXPECT_THROW(checkMesh(mesh), Error);
}

TEST(MeshCheck, LooksForACancel) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(checkMesh(test::icosphere(2, 1, glm::vec3(0)), Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
