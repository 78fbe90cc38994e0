#include "core/rbf/global/global_function.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/parallel.h"
#include "core/mesh/facts/mesh_check.h"
#include "core/mesh/search/point_grid.h"
#include "core/rbf/brick.h"
#include "core/rbf/global/global_block.h"
#include "core/rbf/global/global_fit.h"
#include "core/rbf/surface/iso_surface.h"
#include "tests/support/global_sites.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

GlobalOptions throughAll(GlobalBasis basis) {
  GlobalOptions options;
  options.basis = basis;
  options.accuracy = 0;
  options.nugget = 0;
  return options;
}

std::shared_ptr<const GlobalRbf> sphereModel(GlobalBasis basis = GlobalBasis::biharmonic) {
  return std::make_shared<const GlobalRbf>(fitGlobal(spherePoints(1000, 20, 0.1), throughAll(basis)));
}

// The tolerance that core/rbf/global/global_block.h states, beside the direct sum, on bricks around the surface.
TEST(GlobalFunction, EqualsTheDirectSum) {
  const float cell = 0.15f;
  for (const GlobalBasis b : test::kAllBases) {
    const auto model = sphereModel(b);
    const ImplicitFunction function = globalFunction(model, cell);
    const SurfacePoints places = spherePoints(40, 20);
    double largest = 0;
    for (const glm::vec3& corner : places.positions) {
      std::array<float, kBrickNodes> value{}, coverage{};
      function.sampleBrick(corner, value.data(), coverage.data());
      for (std::size_t n = 0; n < kBrickNodes; n += 7) {
        const glm::dvec3 p = glm::dvec3(corner) + double(cell) * glm::dvec3(nodePlace(int(n)));
        largest = std::max(largest, std::abs(double(value[n]) - model->value(p)));
        EXPECT_GT(coverage[n], 100);
      }
    }
    EXPECT_LT(largest, (b == GlobalBasis::gaussian ? 1e-2 : 1e-3) * double(cell)) << int(b);
  }
}

TEST(GlobalFunction, ItsGradientsAreThoseOfTheModel) {
  const float cell = 0.15f;
  for (const GlobalBasis b : test::kAllBases) {
    const auto model = sphereModel(b);
    const ImplicitFunction function = globalFunction(model, cell);
    for (const glm::vec3& centre : spherePoints(40, 20).positions) {
      const std::array<glm::vec3, 2> places{centre + glm::vec3(0.3f, 0.1f, -0.2f), centre};
      std::array<glm::vec3, 2> found{};
      function.gradients(centre, places, found.data());
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_LT(glm::distance(glm::dvec3(found[i]), model->gradient(glm::dvec3(places[i]))), 2e-3)
            << int(b);
    }
  }
}

// A block sums few of the centres one by one, or it would be no faster than the direct sum.
TEST(GlobalFunction, MostCentresAreFar) {
  const auto model = sphereModel();
  const GlobalBlock block(model->parts(), {1, 0, 0}, 0.1);
  EXPECT_GT(block.nearCentres(), 10u);
  EXPECT_LT(block.nearCentres(), model->size() / 10);
}

TEST(GlobalFunction, ASphereBecomesAClosedMesh) {
  const SurfacePoints points = spherePoints(2000, 20);
  const auto model =
      std::make_shared<const GlobalRbf>(fitGlobal(points, throughAll(GlobalBasis::triharmonic)));
  MeshOptions options;
  options.resolution = 60;
  options.maxGap = 6;
  const float cell = meshCell(points.positions, options);
  const Mesh mesh = extractIsoSurface(globalFunction(model, cell), points, options);
  const MeshCheck check = checkMesh(mesh);
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_EQ(check.euler, 2);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(glm::length(mesh.positions[v]), 20, 0.01);
    EXPECT_GT(glm::dot(mesh.normals[v], glm::normalize(mesh.positions[v])), 0.999f);
  }
}

// Defined everywhere, and still the mesh ends where the points do.
TEST(GlobalFunction, AnOpenSurfaceStaysOpen) {
  SurfacePoints points = spherePoints(3000, 20), half;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.positions[i].z > 0) {
      half.positions.push_back(points.positions[i]);
      half.normals.push_back(points.normals[i]);
      half.confidence.push_back(1);
    }
  const auto model = std::make_shared<const GlobalRbf>(fitGlobal(half, {}));
  MeshOptions options;
  options.resolution = 60;
  const Mesh mesh =
      extractIsoSurface(globalFunction(model, meshCell(half.positions, options)), half, options);
  EXPECT_FALSE(checkMesh(mesh).closed());
  const auto gap = float(options.maxGap * pointSpacing(half.positions));
  for (const glm::vec3& p : mesh.positions) EXPECT_GT(p.z, -1.5f * gap);
}

TEST(GlobalFunction, DoesNotDependOnTheThreads) {
  const SurfacePoints points = spherePoints(1000, 20, 0.1);
  const auto model = sphereModel();
  MeshOptions options;
  options.resolution = 50;
  const auto meshed = [&](int threads) {
    setThreadCount(threads);
    return extractIsoSurface(globalFunction(model, meshCell(points.positions, options)), points, options);
  };
  const Mesh one = meshed(1), two = meshed(2);
  setThreadCount(0);
  EXPECT_EQ(one.positions, two.positions);
  EXPECT_EQ(one.normals, two.normals);
  EXPECT_EQ(one.triangles, two.triangles);
}

}  // namespace
}  // namespace sonoskin
