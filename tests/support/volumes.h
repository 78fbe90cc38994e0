#pragma once

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/volume/volume.h"

namespace sonoskin::test {

// turnedGeometry: a small grid of unequal sides, turned about an oblique axis; `mirrored` flips its last
// axis.
inline Geometry turnedGeometry(bool mirrored = false) {
  Geometry g;
  g.dims = {7, 5, 4};
  g.spacing = {0.5, 0.75, 1.25};
  g.origin = {-12.5, 30.25, 7};
  const double a = 0.4, b = -0.9;
  const glm::dmat3 aboutZ(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1);
  const glm::dmat3 aboutX(1, 0, 0, 0, std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b));
  g.direction = aboutZ * aboutX;
  if (mirrored) g.direction[2] = -g.direction[2];
  return g;
}

// filledVolume: every voxel has its own value, from 0 to 1; bytes count up instead.
template <class T>
Volume<T> filledVolume(const Geometry& g) {
  Volume<T> volume(g);
  for (std::size_t v = 0; v < volume.data.size(); ++v)
    volume.data[v] = std::is_same_v<T, float> ? T(float(v) / float(volume.data.size() - 1)) : T(v);
  return volume;
}

// geometryDistance: the greatest distance in mm between the same corners of two grids; huge if the sizes
// differ.
inline double geometryDistance(const Geometry& a, const Geometry& b) {
  if (a.dims != b.dims) return 1e9;
  double greatest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 index(corner & 1 ? a.dims.x - 1 : 0, corner & 2 ? a.dims.y - 1 : 0,
                           corner & 4 ? a.dims.z - 1 : 0);
    greatest = std::max(greatest, glm::distance(a.toWorld(index), b.toWorld(index)));
  }
  return greatest;
}

}  // namespace sonoskin::test
