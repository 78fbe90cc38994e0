#include "core/skin/surface_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/base/parallel.h"
#include "core/mesh/search/point_grid.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"
#include "tests/support/skin_tables.h"

namespace sonoskin {
namespace {

double sum(const std::vector<float>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(SurfaceSamples, AreasAddUpAndWeightsGiveThePlace) {
  const Mesh mesh = test::icosphere(2, 10, {1, 2, 3});
  for (const double spacing : {5.0, 0.7, 0.2}) {
    const SurfaceSamples samples = sampleSurface(mesh, spacing);
    EXPECT_NEAR(sum(samples.areas), surfaceArea(mesh), 1e-4 * surfaceArea(mesh));
    for (std::size_t i = 0; i < samples.size(); i += 7) {
      const Triangle& t = mesh.triangles[samples.triangles[i]];
      const glm::vec3& w = samples.weights[i];
      const glm::vec3 place =
          w.x * mesh.positions[t[0]] + w.y * mesh.positions[t[1]] + w.z * mesh.positions[t[2]];
      EXPECT_LT(glm::distance(place, samples.positions[i]), 1e-5f);
      EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-6);
      EXPECT_NEAR(glm::length(samples.normals[i]), 1, 1e-6);
      EXPECT_GT(glm::dot(samples.normals[i], place - glm::vec3(1, 2, 3)), 9.f);
      EXPECT_LE(samples.areas[i], float(spacing * spacing) * 1.0001f);
    }
  }
}

TEST(SurfaceSamples, NoPlaceIsFarFromASample) {
  const Mesh mesh = test::icosphere(2, 10, glm::vec3(0));  // sides of 2.8 mm
  const SurfaceSamples coarse = sampleSurface(mesh, 0.5), fine = sampleSurface(mesh, 0.1);
  const PointGrid grid(coarse.positions, 0.5f);
  for (std::size_t i = 0; i < fine.size(); i += 5) {
    float least = 1e9f;
    grid.forEachRun(fine.positions[i], 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t s = first; s < last; ++s)
        least = std::min(least, glm::distance(fine.positions[i], coarse.positions[grid.order()[s]]));
    });
    ASSERT_LT(least, 0.5f);
  }
}

TEST(SurfaceSamples, LinearFunctionsAreIntegratedExactly) {
  const Mesh mesh = test::plane(3, 2, 1);
  const SurfaceSamples samples = sampleSurface(mesh, 0.37);
  double integral = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    integral +=
        double(samples.areas[i]) * (3 + 2 * double(samples.positions[i].x) - double(samples.positions[i].y));
  EXPECT_NEAR(integral, 3 * 24, 1e-3);
}

TEST(SurfaceSamples, LeavesOutTrianglesWithoutAreaAndMakesNormals) {
  Mesh mesh = test::plane(1, 1, 1);
  mesh.normals.clear();
  mesh.triangles.push_back({0, 0, 1});
  const SurfaceSamples samples = sampleSurface(mesh, 0.5);
  EXPECT_NEAR(sum(samples.areas), 4, 1e-5);
  for (const glm::vec3& n : samples.normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

TEST(SurfaceSamples, DoesNotDependOnThreads) {
  const Mesh mesh = test::icosphere(5, 10, glm::vec3(0));
  setThreadCount(1);
  const SurfaceSamples one = sampleSurface(mesh, 0.1);
  setThreadCount(3);
  const SurfaceSamples three = sampleSurface(mesh, 0.1);
  setThreadCount(0);
  EXPECT_EQ(one.positions, three.positions);
  EXPECT_EQ(one.areas, three.areas);
}

TEST(SurfaceSamples, RefusesNonsenseAndCanBeCancelled) {
  test::expectError([] { sampleSurface(Mesh(), 1); }, "without triangles");
  const Mesh mesh = test::icosphere(1, 10, glm::vec3(0));
  test::expectError([&] { sampleSurface(mesh, 0); }, "spacing");
  test::expectError([&] { sampleSurface(mesh, NAN); }, "spacing");
  test::expectError([&] { sampleSurface(mesh, 1e-4); }, "cannot be sampled");
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(sampleSurface(mesh, 1, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
