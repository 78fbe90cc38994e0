#include "core/mesh/iso/marching_cubes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/facts/mesh_check.h"

namespace sonoskin {
namespace {

constexpr double kPi = std::numbers::pi;

Volume<float> sphereDistance(int nodes, double spacing, double radius, const glm::dvec3& offset) {
  Geometry g;
  g.dims = glm::ivec3(nodes);
  g.spacing = glm::dvec3(spacing);
  g.origin = glm::dvec3(-0.5 * spacing * (nodes - 1));
  Volume<float> field(g);
  for (int k = 0; k < nodes; ++k)
    for (int j = 0; j < nodes; ++j)
      for (int i = 0; i < nodes; ++i)
        field.at(i, j, k) = float(glm::length(g.toWorld({i, j, k}) - offset) - radius);
  return field;
}

Volume<float> randomSigns(unsigned seed) {
  Geometry g;
  g.dims = {17, 14, 19};
  Volume<float> field(g, 1.f);
  std::mt19937 random(seed);
  for (int k = 1; k + 1 < g.dims.z; ++k)
    for (int j = 1; j + 1 < g.dims.y; ++j)
      for (int i = 1; i + 1 < g.dims.x; ++i) field.at(i, j, k) = (random() & 1) ? 1.f : -0.7f;
  return field;
}

TEST(MarchingCubes, SphereHasItsAreaVolumeAndTopology) {
  const double radius = 10, h = 0.25;
  const glm::dvec3 centre(0.06, -0.11, 0.03);
  const Mesh mesh = marchingCubes(sphereDistance(96, h, radius, centre), 0);
  const MeshCheck check = checkMesh(mesh);
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_EQ(check.euler, 2);
  EXPECT_EQ(mesh.triangles.size(), 2 * mesh.positions.size() - 4);
  EXPECT_NEAR(surfaceArea(mesh), 4 * kPi * radius * radius, 1e-3 * 4 * kPi * radius * radius);
  EXPECT_NEAR(enclosedVolume(mesh), 4 * kPi / 3 * std::pow(radius, 3),
              1e-3 * 4 * kPi / 3 * std::pow(radius, 3));
  for (const glm::vec3& p : mesh.positions)  // the error of linear interpolation of an exact distance
    ASSERT_LE(std::abs(glm::length(glm::dvec3(p) - centre) - radius), h * h / (8 * (radius - h)) + 2e-6);
}

TEST(MarchingCubes, RandomSignsGiveClosedManifoldsForAllCases) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const MeshCheck check = checkMesh(marchingCubes(randomSigns(seed), 0));
    EXPECT_GT(check.edges, 10000u);
    EXPECT_EQ(check.boundaryEdges, 0u);
    EXPECT_EQ(check.nonManifoldEdges, 0u);
    EXPECT_EQ(check.nonManifoldVertices, 0u);
    EXPECT_EQ(check.misorientedEdges, 0u);
    EXPECT_EQ(check.degenerateTriangles, 0u);
  }
}

TEST(MarchingCubes, PlacesVerticesInTheWorld) {
  Geometry g;
  g.dims = {3, 4, 5};
  g.spacing = {0.5, 1.5, 2};
  g.origin = {7, -3, 11};
  const double c = std::cos(0.3), s = std::sin(0.3);
  g.direction = glm::dmat3(glm::dvec3(c, s, 0), glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1));
  Volume<float> field(g);
  for (std::size_t n = 0; n < field.data.size(); ++n) field.data[n] = float(n % 3);  // the index i
  const Mesh mesh = marchingCubes(field, 1.25f);
  ASSERT_EQ(mesh.positions.size(), 20u);
  EXPECT_EQ(mesh.triangles.size(), 24u);
  for (const glm::vec3& p : mesh.positions) EXPECT_NEAR(g.toIndex(glm::dvec3(p)).x, 1.25, 1e-5);
  Mesh withNormals = mesh;
  computeNormals(withNormals);
  for (const glm::vec3& n : withNormals.normals)
    EXPECT_NEAR(glm::dot(glm::dvec3(n), g.direction[0]), 1, 1e-5);
}

TEST(MarchingCubes, AMirroredGridKeepsNormalsOutward) {
  Volume<float> field = sphereDistance(24, 1, 8, {0.3, 0.2, 0.1});
  const double volume = enclosedVolume(marchingCubes(field, 0));
  field.geometry.direction[0] *= -1;
  field.geometry.origin.x *= -1;
  const Mesh mirrored = marchingCubes(field, 0);
  EXPECT_NEAR(enclosedVolume(mirrored), volume, 1e-6 * volume);
  EXPECT_GT(volume, 0);
  EXPECT_TRUE(checkMesh(mirrored).oriented());
}

TEST(MarchingCubes, CellsWithAnUndefinedNodeStayEmpty) {
  Volume<float> field = sphereDistance(24, 1, 8, {0.3, 0.2, 0.1});
  for (int k = 0; k < 24; ++k)
    for (int j = 0; j < 24; ++j)
      for (int i = 0; i < 12; ++i) field.at(i, j, k) = std::numeric_limits<float>::quiet_NaN();
  const Mesh mesh = marchingCubes(field, 0);
  const MeshCheck check = checkMesh(mesh);
  EXPECT_EQ(check.usedVertices, mesh.positions.size());
  EXPECT_TRUE(check.manifold() && check.oriented());
  EXPECT_EQ(check.euler, 1);  // a bowl
  for (const glm::vec3& p : mesh.positions) ASSERT_GE(p.x, 0.5f);
}

TEST(MarchingCubes, NoVertexIsUnusedWhereverNodesAreUndefined) {
  std::mt19937 random(4);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Volume<float> field = randomSigns(seed);
    for (float& value : field.data)
      if (random() % 8 == 0) value = std::numeric_limits<float>::quiet_NaN();
    const Mesh mesh = marchingCubes(field, 0);
    EXPECT_GT(mesh.positions.size(), 500u);
    EXPECT_EQ(checkMesh(mesh).usedVertices, mesh.positions.size());
    EXPECT_EQ(checkMesh(mesh).degenerateTriangles, 0u);
  }
}

TEST(MarchingCubes, AValueAtTheLevelCountsAsOutside) {
  Geometry g;
  g.dims = {3, 3, 3};
  Volume<float> field(g, 2.f);
  field.at(1, 1, 1) = 2.f;
  EXPECT_TRUE(marchingCubes(field, 2.f).empty());
  field.at(1, 1, 1) = 1.f;
  EXPECT_EQ(marchingCubes(field, 2.f).triangles.size(), 8u);
}

TEST(MarchingCubes, TheThreadCountChangesNothing) {
  const Volume<float> field = randomSigns(9);
  setThreadCount(1);
  const Mesh one = marchingCubes(field, 0);
  setThreadCount(5);
  const Mesh five = marchingCubes(field, 0);
  setThreadCount(0);
  EXPECT_EQ(one.positions, five.positions);
  EXPECT_EQ(one.triangles, five.triangles);
}

TEST(MarchingCubes, OneCellIsEnough) {
  Geometry g;
  g.dims = {2, 2, 2};
  Volume<float> field(g, 1.f);
  field.at(0, 1, 0) = -1;
  const Mesh mesh = marchingCubes(field, 0);
  EXPECT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.positions.size(), 3u);
}

TEST(MarchingCubes, EmptyAndFlatGridsGiveNothing) {
  EXPECT_TRUE(marchingCubes(Volume<float>(), 0).empty());
  Geometry g;
  g.dims = {5, 5, 1};
  EXPECT_TRUE(marchingCubes(Volume<float>(g, -1.f), 0).empty());
}

TEST(MarchingCubes, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(marchingCubes(randomSigns(1), 0, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
