#pragma once

#include <cmath>
#include <functional>

#include "core/volume/volume.h"

namespace sonoskin::test {

inline Geometry grid(glm::ivec3 dims, glm::dvec3 spacing = glm::dvec3(1)) {
  Geometry g;
  g.dims = dims;
  g.spacing = spacing;
  return g;
}

// fill: a volume whose value at world position p is f(p).
inline Volume<float> fill(const Geometry& g, const std::function<double(glm::dvec3)>& f) {
  Volume<float> v(g);
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) v.at(i, j, k) = float(f(g.toWorld({i, j, k})));
  return v;
}

// noise: a deterministic pseudo-random value in [0, 1) of an index.
inline double noise(std::uint64_t n) {
  n += 0x9E3779B97F4A7C15ull;
  n = (n ^ (n >> 30)) * 0xBF58476D1CE4E5B9ull;
  n = (n ^ (n >> 27)) * 0x94D049BB133111EBull;
  return double((n ^ (n >> 31)) >> 11) * 0x1p-53;
}

// speckledSphere: dark fluid around a bright ball, smooth over about two voxels, with noise; values in [0,
// 1].
inline Volume<float> speckledSphere(const Geometry& g, glm::dvec3 centre, double radius, double noiseLevel) {
  std::uint64_t n = 0;
  return fill(g, [&](glm::dvec3 p) {
    const double edge = 0.5 * (1 - std::tanh((glm::length(p - centre) - radius) / (2 * g.minSpacing())));
    return std::clamp(0.1 + 0.7 * edge + noiseLevel * (noise(n++) - 0.5), 0.0, 1.0);
  });
}

}  // namespace sonoskin::test
