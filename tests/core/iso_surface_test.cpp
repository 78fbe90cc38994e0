#include "core/rbf/surface/iso_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/facts/mesh_check.h"
#include "core/mesh/iso/marching_cubes.h"
#include "core/mesh/search/point_grid.h"
#include "core/rbf/compact/csrbf_function.h"
#include "core/rbf/surface/brick_mesher.h"
#include "tests/support/expect_error.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

MeshOptions coarse(int resolution) {
  MeshOptions options;
  options.maxGap = 4;
  options.density = 0.5;
  options.narrowest = 8;
  options.fillHoles = 12;
  options.resolution = resolution;
  return options;
}

// The points whose position `keep` likes.
template <class Keep>
SurfacePoints chosen(const SurfacePoints& points, const Keep& keep) {
  SurfacePoints some;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!keep(points.positions[i])) continue;
    some.positions.push_back(points.positions[i]);
    some.normals.push_back(points.normals[i]);
    some.confidence.push_back(1);
  }
  return some;
}

SurfacePoints hemisphere(const SurfacePoints& sphere) {
  return chosen(sphere, [](const glm::vec3& p) { return p.z >= 0; });
}

double borderLength(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  double length = 0;
  for (const auto& [edge, count] : uses)
    if (count == 1) length += double(glm::distance(mesh.positions[edge.first], mesh.positions[edge.second]));
  return length;
}

TEST(IsoSurface, ASphereIsClosedWithNormalsOutward) {
  const SurfacePoints points = noisySphere();
  ReconstructionOptions smooth;
  smooth.smoothness = 1.5e-4;
  const CsrbfModel model = fitCsrbf(points, smooth);
  const Mesh mesh = extractIsoSurface(model, points, coarse(100));
  const MeshCheck check = checkMesh(mesh);
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_EQ(check.euler, 2);
  EXPECT_EQ(check.usedVertices, mesh.positions.size());
  EXPECT_GT(enclosedVolume(mesh), 0);
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  double squares = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3 p = mesh.positions[v];
    squares += std::pow(glm::length(p) - 40.f, 2);
    ASSERT_GT(glm::dot(mesh.normals[v], glm::normalize(p)), 0.97f);
    ASSERT_GT(glm::dot(mesh.normals[v], glm::normalize(model.gradient(p))), 0.9999f);
    ASSERT_LT(std::abs(model.sample(p).value), 0.03f);
  }
  EXPECT_LT(std::sqrt(squares / double(mesh.positions.size())), 0.5 * 0.3);  // half the noise of the points
}

// The sparse bricks must give the triangles that marching cubes gives on the whole grid.
TEST(IsoSurface, BricksGiveTheMeshOfTheDenseGrid) {
  const SurfacePoints points = spherePoints(3000, 10, 0.05);
  const CsrbfModel model = fitCsrbf(points, {});
  const float cell = 0.4f;
  const auto everywhere = [](const glm::vec3&) { return true; };
  const BrickField field = sampleBricks(csrbfFunction(model, cell), points.positions, 6 * cell, everywhere);
  const Mesh sparse = meshBricks(field).mesh;

  Geometry g;
  g.dims = kBrickEdge * field.map.bricks();
  g.spacing = glm::dvec3(double(cell));
  g.origin = glm::dvec3(field.origin);
  Volume<float> dense(g);
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const CsrbfModel::Sample s = model.sample(glm::vec3(g.toWorld({i, j, k})));
        dense.at(i, j, k) = s.coverage < 0.01f ? std::numeric_limits<float>::quiet_NaN() : s.value;
      }
  const Mesh expected = marchingCubes(dense, 0);
  ASSERT_EQ(sparse.positions.size(), expected.positions.size());
  ASSERT_EQ(sparse.triangles.size(), expected.triangles.size());
  const auto centroids = [](const Mesh& mesh) {
    std::vector<std::array<int, 3>> result;
    for (const Triangle& t : mesh.triangles) {
      const glm::vec3 c = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) * (100.f / 3);
      result.push_back({int(std::lround(c.x)), int(std::lround(c.y)), int(std::lround(c.z))});
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto a = centroids(sparse), b = centroids(expected);
  std::size_t same = 0;  // up to a hundredth of a mm, except where rounding falls on the limit
  std::vector<std::array<int, 3>> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  same = common.size();
  EXPECT_GT(double(same), 0.99 * double(a.size()));
  EXPECT_EQ(enclosedVolume(sparse) > 0, enclosedVolume(expected) > 0);
  EXPECT_NEAR(enclosedVolume(sparse), enclosedVolume(expected), 1e-5 * enclosedVolume(expected));
}

TEST(IsoSurface, AnOpenSurfaceIsCutOffWhereItIsNotSupported) {
  const SurfacePoints points = hemisphere(noisySphere());
  const CsrbfModel model = fitCsrbf(points, {});
  MeshOptions options = coarse(80);
  const Mesh mesh = extractIsoSurface(model, points, options);
  const MeshCheck check = checkMesh(mesh);
  EXPECT_GT(check.boundaryEdges, 100u);
  EXPECT_TRUE(check.manifold() && check.oriented());
  const double h = pointSpacing(points.positions);
  float lowest = 0;
  for (const glm::vec3& p : mesh.positions) {
    lowest = std::min(lowest, p.z);
    ASSERT_GT(model.sample(p).coverage, 0.3f * float(options.support));  // the border is smoothed
  }
  EXPECT_GT(lowest, -float(1.3 * options.maxGap * h) - 0.5f);  // a point is within the gap
  options.support = 0.05;
  options.maxGap = 100;
  options.density = 0;
  float farther = 0;
  for (const glm::vec3& p : extractIsoSurface(model, points, options).positions)
    farther = std::min(farther, p.z);
  EXPECT_LT(farther, lowest - 1);
}

// The border of a disc with teeth must run along a circle, not around every tooth.
TEST(IsoSurface, TheBorderIsSmooth) {
  SurfacePoints disc;
  const SurfacePoints plane = planePoints(60, 0.05);
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const glm::vec3 p = plane.positions[i] - glm::vec3(30, 30, 0);
    if (glm::length(p) > 24 + 2 * std::sin(30 * std::atan2(p.y, p.x))) continue;
    disc.positions.push_back(plane.positions[i]);
    disc.normals.push_back(plane.normals[i]);
    disc.confidence.push_back(1);
  }
  MeshOptions options = coarse(150);
  options.support = 0.1;
  options.maxGap = 2;
  const Mesh mesh = extractIsoSurface(fitCsrbf(disc, {}), disc, options);
  const double length = borderLength(mesh);
  const double radius = std::sqrt(surfaceArea(mesh) / std::numbers::pi);
  EXPECT_NEAR(radius, 24, 0.3);
  // By the distance to the points it is 1.36 times the circle, smoothed 1.10, by their density 1.04.
  EXPECT_LT(length, 1.08 * 2 * std::numbers::pi * radius);
}

TEST(IsoSurface, AHalfSphereEndsInACircleWhereItsPointsDo) {
  const SurfacePoints points = hemisphere(spherePoints(20000, 40, 0.05));  // a point per mm²
  const Mesh mesh = extractIsoSurface(fitCsrbf(points, {}), points, coarse(120));
  const double circle = 2 * std::numbers::pi * 40;
  // Within 0.2 mm of a circle, but the cells' irregular triangles make it wavy: up to a fifth longer.
  EXPECT_NEAR(borderLength(mesh), 1.1 * circle, 0.1 * circle);
  EXPECT_NEAR(surfaceArea(mesh), 40 * circle, 0.01 * 40 * circle);
  ASSERT_EQ(mesh.measured.size(), mesh.positions.size());
  int beyond = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3 p = mesh.positions[v];
    ASSERT_GT(p.z, -0.8f);
    ASSERT_LT(std::abs(glm::length(p) - 40), p.z < 3 ? 0.3f : 0.15f);
    if (p.z > 5) {
      ASSERT_EQ(mesh.measured[v], 1);
    }
    if (p.z < 0) {
      ASSERT_LT(mesh.measured[v], 0.3f);
      ++beyond;
    }
  }
  EXPECT_GT(beyond, 100);
}

// A half sphere on which a tongue of points hangs, and strays around it.
TEST(IsoSurface, ATongueOfSparsePointsIsCutOff) {
  int n = 0;
  const SurfacePoints points = chosen(spherePoints(20000, 40, 0.05), [&](const glm::vec3& p) {
    const bool isTongue = p.z > -15 && p.y > 0 && std::abs(p.x) < 3;
    return p.z >= 0 || (isTongue && n++ % 2 == 0) || (p.z > -20 && n++ % 23 == 0);
  });
  const CsrbfModel model = fitCsrbf(points, {});
  MeshOptions options = coarse(120);
  const auto lowest = [&] {
    float low = 0;
    for (const glm::vec3& p : extractIsoSurface(model, points, options).positions) low = std::min(low, p.z);
    return low;
  };
  EXPECT_GT(lowest(), -3);
  options.density = options.narrowest = 0;
  EXPECT_LT(lowest(), -12);
}

TEST(IsoSurface, AHoleInThePointsIsClosedAndMarked) {
  const SurfacePoints points = chosen(spherePoints(20000, 40, 0.05), [](const glm::vec3& p) {
    return p.z < 0 || std::hypot(p.x, p.y) > 4.2f;
  });
  const CsrbfModel model = fitCsrbf(points, {});
  MeshOptions options = coarse(120);
  options.maxGap = 6;
  const Mesh mesh = extractIsoSurface(model, points, options);
  EXPECT_TRUE(checkMesh(mesh).closed());
  int marked = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3 p = mesh.positions[v];
    const float across = p.z > 0 ? std::hypot(p.x, p.y) : 40;
    if (across < 2) {
      ASSERT_LT(mesh.measured[v], 0.1f);
      ASSERT_NEAR(glm::length(p), 40, 0.4);
      ++marked;
    }
    if (across > 10) {
      ASSERT_GT(mesh.measured[v], 0.9f);
    }
  }
  EXPECT_GT(marked, 10);
  options.fillHoles = 0;
  EXPECT_EQ(checkMesh(extractIsoSurface(model, points, options)).euler, 1);
}

TEST(IsoSurface, ASphereHasTheAreaAndVolumeOfOne) {
  constexpr double kRadius = 40;
  const SurfacePoints points = spherePoints(20000, kRadius);
  ReconstructionOptions fine;
  fine.smoothness = 1e-5;
  const Mesh mesh = extractIsoSurface(fitCsrbf(points, fine), points, coarse(200));
  const MeshCheck check = checkMesh(mesh);
  EXPECT_TRUE(check.closed() && check.manifold() && check.oriented());
  EXPECT_EQ(check.euler, 2);
  const double area = 4 * std::numbers::pi * kRadius * kRadius;
  EXPECT_NEAR(surfaceArea(mesh), area, 0.002 * area);
  EXPECT_NEAR(enclosedVolume(mesh), area * kRadius / 3, 0.002 * area * kRadius / 3);
}

TEST(IsoSurface, TheCellMayBeGivenInMillimetres) {
  const SurfacePoints points = spherePoints(3000, 10);
  MeshOptions options = coarse(400);
  options.cell = 0.5;
  EXPECT_EQ(meshCell(points.positions, options), 0.5f);
  const Mesh mesh = extractIsoSurface(fitCsrbf(points, {}), points, options);
  // Marching cubes makes about 2.4 triangles of half a cell's face per face of area.
  EXPECT_NEAR(double(mesh.triangles.size()), 1256 / (0.5 * 0.5) * 3, 3000);
  options.cell = 0.001;
  test::expectError([&] { meshCell(points.positions, options); }, "mesh.cell");
}

TEST(IsoSurface, TheThreadCountChangesNothing) {
  const SurfacePoints points = spherePoints(3000, 10, 0.05);
  Mesh meshes[2];
  for (const int threads : {1, 5}) {
    setThreadCount(threads);
    meshes[threads == 5] = extractIsoSurface(fitCsrbf(points, {}), points, coarse(60));
  }
  setThreadCount(0);
  EXPECT_EQ(meshes[0].positions, meshes[1].positions);
  EXPECT_EQ(meshes[0].normals, meshes[1].normals);
  EXPECT_EQ(meshes[0].triangles, meshes[1].triangles);
}

TEST(IsoSurface, RefusesNothingAndStopsWhenCancelled) {
  const SurfacePoints points = spherePoints(1000, 10);
  EXPECT_THROW(extractIsoSurface(CsrbfModel(), {}, {}), Error);
  const CsrbfModel model = fitCsrbf(points, {});
  ProgressSink sink;
  sink.report = [&](double fraction) { sink.cancel = fraction > 0.3; };
  EXPECT_THROW(extractIsoSurface(model, points, coarse(100), Progress(sink)), Cancelled);
}

TEST(IsoSurface, BrickMapRemembersWhatWasInserted) {
  BrickMap map({20, 9, 33});
  EXPECT_EQ(map.find({3, 4, 5}), BrickMap::kNone);
  map.insert({3, 4, 5}, 7);
  map.insert({19, 8, 32}, 8);
  EXPECT_EQ(map.find({3, 4, 5}), 7);
  EXPECT_EQ(map.find({19, 8, 32}), 8);
  EXPECT_EQ(map.find({3, 4, 6}), BrickMap::kNone);
  EXPECT_EQ(map.find({-1, 4, 5}), BrickMap::kNone);
  EXPECT_EQ(map.find({3, 9, 5}), BrickMap::kNone);
}

}  // namespace
}  // namespace sonoskin
