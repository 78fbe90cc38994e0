#pragma once

#include <algorithm>
#include <random>

#include "core/pipeline/pipeline.h"
#include "tests/benchmarks/phantom_input.h"

namespace sonoskin {

// scanPoints: the surface points of the simulated scan with default parameters, 44,000.
inline const SurfacePoints& scanPoints() {
  static const Results results = Pipeline().run(phantomInput(), Parameters{}, Goal::points);
  return *results.points;
}

// relaxedScanPoints: the same with the filters relaxed as the thesis has it, so that walls, inner tissue and noise stay:
// 113,000 as the thesis' first volume.
inline const SurfacePoints& relaxedScanPoints() {
  static const Results results = [] {
    Parameters parameters;
    SurfaceOptions& surface = parameters.surface;
    surface.facing = -1;
    surface.firstHit = 0;
    surface.minClusterArea = 5;
    surface.strongShare = 0;
    surface.lobeStrength = 0;
    surface.threshold = 0.21;
    return Pipeline().run(phantomInput(), parameters, Goal::points);
  }();
  return *results.points;
}

// skinPoints: points spread evenly over the phantom's true skin, with the noise of a scan: half a voxel along the
// normals, and normals that are 7 degrees off in the mean.
inline SurfacePoints skinPoints(std::size_t count) {
  static const Mesh skin = makePhantomTruth(PhantomOptions{});
  constexpr double kNoise = 0.5;                     // voxels
  constexpr double kTilt = 7 * 3.14159265 / 180;     // mean angle
  constexpr double kRayleighMean = 1.2533141373155;  // of the length of two standard normal components
  const double noise = kNoise * phantomInput().volume->geometry.minSpacing();
  std::vector<double> areaUpTo;
  double area = 0;
  for (const Triangle& t : skin.triangles) {
    const glm::dvec3 a(skin.positions[t[0]]), b(skin.positions[t[1]]), c(skin.positions[t[2]]);
    areaUpTo.push_back(area += 0.5 * glm::length(glm::cross(b - a, c - a)));
  }
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  SurfacePoints points;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = area * (double(i) + uniform(random)) / double(count);
    const auto found = std::lower_bound(areaUpTo.begin(), areaUpTo.end() - 1, at);
    const Triangle& t = skin.triangles[std::size_t(found - areaUpTo.begin())];
    const double root = std::sqrt(uniform(random)), share = uniform(random);
    const double weights[3] = {1 - root, root * (1 - share), root * share};
    glm::dvec3 p(0), n(0);
    for (std::size_t v = 0; v < 3; ++v) {
      p += weights[v] * glm::dvec3(skin.positions[t[v]]);
      n += weights[v] * glm::dvec3(skin.normals[t[v]]);
    }
    n = glm::normalize(n);
    const glm::dvec3 tilt(normal(random), normal(random), normal(random));
    points.positions.emplace_back(p + noise * normal(random) * n);
    points.normals.emplace_back(glm::normalize(n + kTilt / kRayleighMean * (tilt - glm::dot(tilt, n) * n)));
    points.confidence.push_back(1);
  }
  return points;
}

}  // namespace sonoskin
