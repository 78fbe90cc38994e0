#pragma once

#include <cmath>
#include <random>

#include "core/surface/surface_points.h"

namespace sonoskin {

// spherePoints: points spread evenly over a sphere around the origin, white noise along the normals.
inline SurfacePoints spherePoints(int count, double radius, double noise = 0, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  SurfacePoints points;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z), angle = i * 2.399963229728653;
    const glm::dvec3 n(r * std::cos(angle), r * std::sin(angle), z);
    points.positions.push_back(glm::vec3((radius + noise * normal(random)) * n));
    points.normals.push_back(glm::vec3(n));
    points.confidence.push_back(1);
  }
  return points;
}

// planePoints: one random point per unit square of z = 0, squares along x and y, white noise along z.
inline SurfacePoints planePoints(int squares, double noise = 0, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  SurfacePoints points;
  for (int y = 0; y < squares; ++y)
    for (int x = 0; x < squares; ++x) {
      const double px = x + uniform(random), py = y + uniform(random);
      points.positions.push_back(glm::vec3(px, py, noise * normal(random)));
      points.normals.push_back({0, 0, 1});
      points.confidence.push_back(1);
    }
  return points;
}

// noisySphere: the surface points and options behind most tests of the fit; 20,000 points, a second to fit.
inline SurfacePoints noisySphere() { return spherePoints(20000, 40, 0.3); }

}  // namespace sonoskin
