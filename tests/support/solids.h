#pragma once

#include <functional>

#include "core/mesh/iso/marching_cubes.h"

namespace sonoskin::test {

// solid: the zero set of a signed distance, negative inside, in a box around the origin with `half` mm to each side.
inline Mesh solid(const std::function<double(const glm::dvec3&)>& distance, const glm::dvec3& half,
                  double cell) {
  Geometry g;
  g.dims = glm::ivec3(glm::ceil(2.0 * half / cell)) + 1;
  g.spacing = glm::dvec3(cell);
  g.origin = -0.5 * cell * glm::dvec3(g.dims - 1);
  Volume<float> field(g);
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) field.at(i, j, k) = float(distance(g.toWorld({i, j, k})));
  Mesh mesh = marchingCubes(field, 0);
  computeNormals(mesh);
  return mesh;
}

inline double ball(const glm::dvec3& x, const glm::dvec3& centre, double radius) {
  return glm::distance(x, centre) - radius;
}

// rod: around the line from a to b.
inline double rod(const glm::dvec3& x, const glm::dvec3& a, const glm::dvec3& b, double radius) {
  const glm::dvec3 along = b - a;
  const double t = glm::clamp(glm::dot(x - a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(x, a + t * along) - radius;
}

}  // namespace sonoskin::test
