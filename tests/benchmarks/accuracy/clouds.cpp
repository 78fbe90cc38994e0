#include "tests/benchmarks/accuracy/clouds.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "core/volume/gaussian.h"
#include "tests/benchmarks/accuracy/truth.h"

namespace sonoskin::accuracy {
namespace {

constexpr float kNearSkin = 4;                              // voxels
constexpr double kSphereRadius = 30, kSphereSpacing = 0.5;  // mm

// The points before the echo's offset was taken away, moved to the middles of their voxels, and the offset again.
SurfacePoints roundToVoxels(SurfacePoints points, const Geometry& geometry, double offset) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 normal(points.normals[i]);
    const glm::dvec3 index = geometry.toIndex(glm::dvec3(points.positions[i]) + offset * normal);
    points.positions[i] = glm::vec3(geometry.toWorld(glm::round(index)) - offset * normal);
  }
  return points;
}

SurfacePoints keepVisible(const SurfacePoints& points, const Truth& truth) {
  SurfacePoints kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 index = truth.geometry().toIndex(glm::dvec3(points.positions[i]));
    if (!truth.nearVisible(glm::vec3(index), kNearSkin)) continue;
    kept.positions.push_back(points.positions[i]);
    kept.normals.push_back(points.normals[i]);
    kept.confidence.push_back(points.confidence[i]);
  }
  return kept;
}

// White noise of RMS 1 after a Gaussian of `sigma` voxels; 0 leaves it white.
Volume<float> noiseVolume(const Geometry& geometry, double sigma, unsigned seed) {
  Volume<float> noise(geometry);
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  for (float& value : noise.data) value = normal(random);
  if (sigma > 0) noise = gaussianBlur(noise, sigma);
  double squares = 0;
  for (const float value : noise.data) squares += double(value) * double(value);
  const auto scale = float(1 / std::sqrt(squares / double(noise.data.size())));
  for (float& value : noise.data) value *= scale;
  return noise;
}

// A sphere around the origin with exact normals.
Mesh sphereMesh(double radius) {
  constexpr int kAround = 800, kDown = 400;
  Mesh mesh;
  for (int j = 0; j <= kDown; ++j)
    for (int i = 0; i < kAround; ++i) {
      const double theta = std::numbers::pi * j / kDown, phi = 2 * std::numbers::pi * i / kAround;
      const glm::vec3 n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      mesh.normals.push_back(n);
      mesh.positions.push_back(float(radius) * n);
    }
  const auto at = [](int i, int j) { return std::uint32_t(j * kAround + i % kAround); };
  for (int j = 0; j < kDown; ++j)
    for (int i = 0; i < kAround; ++i) {
      if (j > 0) mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      if (j + 1 < kDown) mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  return mesh;
}

Geometry sphereGeometry() {
  Geometry g;
  const int n = int(2 * kSphereRadius / kSphereSpacing) + 24;
  g.dims = glm::ivec3(n);
  g.spacing = glm::dvec3(kSphereSpacing);
  g.origin = glm::dvec3(-0.5 * (n - 1) * kSphereSpacing) + glm::dvec3(0.11, -0.07, 0.19);  // off the lattice
  return g;
}

}  // namespace

Cloud phantomCloud(const std::string& level, double snr, const Parameters& parameters) {
  Parameters changed = parameters;
  changed.phantom.snr = snr;
  const Scan scan = makePhantomScan(changed.phantom);
  Pipeline pipeline;
  const Results results = pipeline.run(scan, changed, Goal::points);
  const SurfacePoints points = keepVisible(*results.points, Truth(changed.phantom));
  return {fmt::format("phantom {}", level), points,
          roundToVoxels(points, scan.volume->geometry, results.edge.shift + results.edge.depth),
          makePhantomTruth(changed.phantom)};
}

Cloud sphereCloud(double jitter) {
  const Geometry g = sphereGeometry();
  const Volume<float> wander = noiseVolume(g, 1.5, 1), grain = noiseVolume(g, 0, 2),
                      speckle = noiseVolume(g, 0, 3);
  Volume<float> classified(g), grey(g);
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const std::size_t at = g.index(i, j, k);
        const double outside = (glm::length(g.toWorld({i, j, k})) - kSphereRadius) / kSphereSpacing;
        const double f = outside + jitter * double(wander.data[at]);
        classified.data[at] = float(1 / (1 + f * f / 2.25) * (1 + 0.03 * double(grain.data[at])));
        grey.data[at] = float(0.5 * (1 - std::tanh(f / 2)) * (1 + 0.15 * double(speckle.data[at])));
      }
  const Volume<float> ridge = gaussianBlur(classified, 0.7), lowPassed = gaussianBlur(grey, 1.5);
  SurfaceOptions options;
  options.threshold = 0.5;
  options.facing = -1;
  options.borderMargin = 0;
  const std::vector<SurfaceVoxel> voxels = thin(ridge, lowPassed, {}, options);
  const SurfacePoints points = extractSurfacePoints(voxels, lowPassed);
  return {fmt::format("sphere, jitter {}", jitter), points, roundToVoxels(points, g, 0),
          sphereMesh(kSphereRadius)};
}

}  // namespace sonoskin::accuracy
