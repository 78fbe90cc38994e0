#include "core/mesh/search/mesh_distance.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/iso/marching_cubes.h"
#include "core/mesh/search/triangle_tree.h"

namespace sonoskin {
namespace {

Mesh sphere(double radius, int nodes = 48, const glm::dvec3& centre = {0.1, 0.2, 0.3}) {
  Geometry g;
  g.dims = glm::ivec3(nodes);
  g.spacing = glm::dvec3(2.4 * radius / nodes);
  g.origin = -0.5 * (nodes - 1) * g.spacing;
  Volume<float> field(g);
  for (int k = 0; k < nodes; ++k)
    for (int j = 0; j < nodes; ++j)
      for (int i = 0; i < nodes; ++i)
        field.at(i, j, k) = float(glm::length(g.toWorld({i, j, k}) - centre) - radius);
  return marchingCubes(field, 0);
}

Mesh square(float z) {
  Mesh mesh;
  mesh.positions = {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// Distance to a triangle by trying many places of it: an upper bound that is tight to the step.
float sampledDistance(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  float least = 1e30f;
  const int steps = 200;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) {
      const float u = float(i) / steps, v = float(j) / steps;
      least = std::min(least, glm::distance(p, (1 - u - v) * a + u * b + v * c));
    }
  return least;
}

TEST(MeshDistance, ClosestPointEqualsASampledSearch) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> uniform(-1, 1);
  const auto point = [&] { return glm::vec3(uniform(random), uniform(random), uniform(random)); };
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 p = 2.f * point(), a = point(), b = point(), c = point();
    const ClosestPoint found = closestPointOnTriangle(p, a, b, c);
    const float distance = glm::distance(p, found.position);
    EXPECT_LE(distance, sampledDistance(p, a, b, c) + 1e-5f);
    EXPECT_GE(distance, sampledDistance(p, a, b, c) - 0.02f);
    EXPECT_LT(glm::distance(found.position, found.weights.x * a + found.weights.y * b + found.weights.z * c),
              1e-5f);
    EXPECT_NEAR(found.weights.x + found.weights.y + found.weights.z, 1, 1e-5f);
  }
}

TEST(MeshDistance, ClosestPointOfTrianglesWithoutArea) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-10, 10);
  const auto point = [&] { return glm::vec3(uniform(random), uniform(random), uniform(random)); };
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 a = point(), b = point(), p = point();
    const float along = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.f, 1.f);
    const float expected = glm::distance(p, a + along * (b - a));
    for (const auto& [x, y, z] : {std::array{a, b, b}, {a, a, b}, {a, b, a}, {a, b, 0.5f * (a + b)}}) {
      const ClosestPoint found = closestPointOnTriangle(p, x, y, z);
      EXPECT_NEAR(glm::distance(p, found.position), expected, 1e-4f);
      EXPECT_NEAR(found.weights.x + found.weights.y + found.weights.z, 1, 1e-5f);
    }
    EXPECT_EQ(closestPointOnTriangle(p, a, a, a).position, a);
  }
}

TEST(MeshDistance, TreeFindsWhatBruteForceFinds) {
  const Mesh mesh = sphere(10, 24);
  const TriangleTree tree(mesh);
  std::mt19937 random(4);
  std::uniform_real_distribution<float> uniform(-15, 15);
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 p(uniform(random), uniform(random), uniform(random));
    float least = 1e30f;
    for (const Triangle& t : mesh.triangles)
      least =
          std::min(least, glm::distance(p, closestPointOnTriangle(p, mesh.positions[t[0]],
                                                                  mesh.positions[t[1]], mesh.positions[t[2]])
                                               .position));
    EXPECT_NEAR(std::sqrt(tree.nearest(p, std::uint32_t(i)).squaredDistance), least, 1e-5f);
    EXPECT_FALSE(tree.nearestWithin(p, 0.99f * least));
    const auto within = tree.nearestWithin(p, 1.01f * least + 1e-4f);
    ASSERT_TRUE(within);
    EXPECT_NEAR(std::sqrt(within->squaredDistance), least, 1e-5f);
  }
}

TEST(MeshDistance, ConcentricSpheresAreTheirRadiiApart) {
  const MeshDistances d = measureDistances(sphere(21), sphere(20));
  for (const DistanceStatistics& s : {d.aToB, d.bToA, d.visibleAToB, d.visibleBToA}) {
    EXPECT_NEAR(s.mean, 1, 0.02);
    EXPECT_NEAR(s.rms, 1, 0.02);
    EXPECT_NEAR(s.p95, 1, 0.03);
    EXPECT_NEAR(s.max, 1, 0.05);
    EXPECT_LT(s.normalAngle, 1);
  }
  EXPECT_NEAR(d.aToB.signedMean, 1, 0.02);
  EXPECT_NEAR(d.aToB.signedMedian, 1, 0.02);
  EXPECT_NEAR(d.bToA.signedMean, -1, 0.02);
  EXPECT_NEAR(d.aToB.area, 4 * M_PI * 441, 15);
}

TEST(MeshDistance, AMeshHasNoDistanceFromItself) {
  const Mesh mesh = sphere(20);
  const MeshDistances d = measureDistances(mesh, mesh);
  EXPECT_LT(d.aToB.max, 1e-5);
  EXPECT_LT(d.aToB.normalAngle, 1);
}

TEST(MeshDistance, CountsOnlyWhatCanHaveBeenSeen) {
  Mesh b = sphere(20);
  for (const glm::vec3& p : b.positions) b.visibility.push_back(p.z > 0 ? 1.f : 0.f);
  Mesh a = sphere(20);
  for (glm::vec3& p : a.positions)
    if (p.z < -2) p *= 1.5f;  // wrong where it cannot be known
  const MeshDistances d = measureDistances(a, b);
  EXPECT_GT(d.aToB.max, 9);
  EXPECT_LT(d.visibleAToB.max, 0.5);
  EXPECT_LT(d.visibleBToA.max, 0.5);
  EXPECT_NEAR(d.visibleAToB.area, 2 * M_PI * 400, 100);
  EXPECT_LT(d.visibleAToB.vertices, d.aToB.vertices);
}

TEST(MeshDistance, WeighsVerticesByArea) {
  Mesh a = square(0.5f);  // above b, and a finely meshed speck far away
  for (int i = 0; i < 100; ++i) {
    const auto base = std::uint32_t(a.positions.size());
    for (const glm::vec3& corner : {glm::vec3(0, 0, 9), glm::vec3(1e-3f, 0, 9), glm::vec3(0, 1e-3f, 9)})
      a.positions.push_back(corner);
    a.triangles.push_back({base, base + 1, base + 2});
  }
  const MeshDistances d = measureDistances(a, square(0));
  EXPECT_NEAR(d.aToB.mean, 0.5, 1e-3);
  EXPECT_NEAR(d.aToB.p95, 0.5, 1e-6);
  EXPECT_NEAR(d.aToB.max, 9, 1e-5);
  EXPECT_NEAR(d.aToB.signedMedian, 0.5, 1e-6);
}

TEST(MeshDistance, TheThreadCountChangesNothing) {
  setThreadCount(1);
  const MeshDistances one = measureDistances(sphere(21), sphere(20));
  setThreadCount(4);
  const MeshDistances four = measureDistances(sphere(21), sphere(20));
  setThreadCount(0);
  EXPECT_EQ(one.aToB.rms, four.aToB.rms);
  EXPECT_EQ(one.bToA.signedMedian, four.bToA.signedMedian);
}

TEST(MeshDistance, RefusesAnEmptyMeshAndStopsWhenCancelled) {
  EXPECT_THROW(measureDistances(square(0), Mesh()), Error);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(measureDistances(square(0), square(1), Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
