#include "core/mesh/repair/smooth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/facts/mesh_check.h"
#include "core/mesh/half_edges.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

// A cube from -10 to 10 with n x n squares on every face.
Mesh cube(int n) {
  Mesh mesh;
  std::map<std::tuple<int, int, int>, std::uint32_t> numbers;
  const auto vertex = [&](glm::ivec3 g) {
    const auto [found, isNew] = numbers.try_emplace({g.x, g.y, g.z}, std::uint32_t(mesh.positions.size()));
    if (isNew) mesh.positions.push_back(glm::vec3(g) * (20.f / float(n)) - 10.f);
    return found->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int u, int v) {
            glm::ivec3 g;
            g[axis] = side;
            g[(axis + 1) % 3] = u;
            g[(axis + 2) % 3] = v;
            return vertex(g);
          };
          std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
          if (side == 0) std::swap(b, d);
          mesh.triangles.push_back({a, b, c});
          mesh.triangles.push_back({a, c, d});
        }
  return mesh;
}

void addNoise(Mesh& mesh, float width) {
  std::mt19937 random(7);
  std::normal_distribution<float> normal(0, width);
  for (glm::vec3& p : mesh.positions) p += glm::vec3(normal(random), normal(random), normal(random));
}

bool isOnEdge(const glm::vec3& p) {
  return int(std::abs(p.x) > 9.99f) + int(std::abs(p.y) > 9.99f) + int(std::abs(p.z) > 9.99f) > 1;
}

// Root mean square distance from the cube of the vertices on its edges (or faces).
double distanceFromCube(const Mesh& mesh, const Mesh& clean, bool edges) {
  double sum = 0, count = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (isOnEdge(clean.positions[v]) != edges) continue;
    const glm::vec3 p = glm::abs(mesh.positions[v]);
    const float off = std::max({p.x, p.y, p.z}) - 10.f;  // of the face
    glm::vec3 sorted = p;
    std::sort(&sorted.x, &sorted.x + 3);
    sum += double(off * off);
    if (edges) sum += double((sorted.y - 10.f) * (sorted.y - 10.f));
    ++count;
  }
  return std::sqrt(sum / count);
}

TEST(Smooth, NoiseOnACubeFallsAndItsEdgesStay) {
  const Mesh clean = cube(24);
  Mesh mesh = clean;
  addNoise(mesh, 0.08f);
  const double faces = distanceFromCube(mesh, clean, false), edges = distanceFromCube(mesh, clean, true);
  smoothMesh(mesh, 10);
  EXPECT_LT(distanceFromCube(mesh, clean, false), 0.35 * faces);
  EXPECT_LT(distanceFromCube(mesh, clean, true), 0.8 * edges);
  EXPECT_NEAR(enclosedVolume(mesh), 8000, 0.005 * 8000);
}

TEST(Smooth, ACleanCubeStays) {
  const Mesh clean = cube(16);
  Mesh mesh = clean;
  smoothMesh(mesh, 20);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_LT(glm::distance(mesh.positions[v], clean.positions[v]), 0.02f);
}

TEST(Smooth, ANoisySphereKeepsItsVolume) {
  Mesh mesh = test::icosphere(5, 10, {});
  addNoise(mesh, 0.05f);
  const double before = enclosedVolume(mesh);
  const auto roughness = [&] {
    double sum = 0;
    for (const glm::vec3& p : mesh.positions) sum += std::pow(double(glm::length(p)) - 10, 2);
    return std::sqrt(sum / double(mesh.positions.size()));
  };
  const double rough = roughness();
  smoothMesh(mesh, 20);
  EXPECT_NEAR(enclosedVolume(mesh), before, 0.005 * before);
  EXPECT_LT(roughness(), 0.4 * rough);
  for (std::size_t v = 0; v < mesh.normals.size(); ++v)
    EXPECT_GT(glm::dot(mesh.normals[v], glm::normalize(mesh.positions[v])), 0.98f);
}

TEST(Smooth, BordersMoveAlongThemselves) {
  Mesh mesh = test::icosphere(4, 10, {});
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return mesh.positions[t[0]].z < 0 || mesh.positions[t[1]].z < 0 || mesh.positions[t[2]].z < 0;
  });
  compactVertices(mesh);
  const Mesh before = mesh;
  smoothMesh(mesh, 10);
  const auto opposite = oppositeHalfEdges(mesh.triangles, mesh.positions.size());
  const auto loops = borderLoops(mesh.triangles, opposite);
  ASSERT_EQ(loops.size(), 1u);
  for (const auto h : loops[0]) {
    const auto v = originOf(mesh.triangles, h);
    EXPECT_LT(glm::distance(mesh.positions[v], before.positions[v]), 0.05f);
  }
}

TEST(Smooth, NoStepsSameOnAnyNumberOfThreadsAndCancelled) {
  Mesh noisy = test::icosphere(4, 10, {});
  addNoise(noisy, 0.1f);
  Mesh none = noisy, one = noisy, two = noisy;
  smoothMesh(none, 0);
  EXPECT_EQ(none.positions, noisy.positions);
  setThreadCount(1);
  smoothMesh(one, 5);
  setThreadCount(2);
  smoothMesh(two, 5);
  setThreadCount(0);
  EXPECT_EQ(one.positions, two.positions);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(smoothMesh(one, 5, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
