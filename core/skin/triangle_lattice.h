#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// TriangleLattice: places on a mesh between which values are interpolated: the vertices, and where triangles are too large,
// a net of further ones on each.
class TriangleLattice {
 public:
  // longest   mm: no side of a part is longer
  TriangleLattice(const Mesh& mesh, double longest);

  const std::vector<glm::vec3>& positions() const { return positions_; }
  const std::vector<glm::vec3>& normals() const { return normals_; }

  // value: between the places of a triangle.
  //   weights   of its corners, none negative, sum 1
  template <class T>
  T value(const std::vector<T>& atPlaces, const Triangle& corners, std::uint32_t triangle,
          const glm::vec3& weights) const {
    const std::uint32_t n = parts_[triangle];
    if (n <= 1)
      return weights.x * atPlaces[corners[0]] + weights.y * atPlaces[corners[1]] +
             weights.z * atPlaces[corners[2]];
    // The part: a square of the net, and which half of it.
    const glm::vec2 at = float(n) * glm::vec2(weights.y, weights.z);
    std::uint32_t u = std::min(std::uint32_t(at.x), n - 1), v = std::min(std::uint32_t(at.y), n - 1 - u);
    float a = at.x - float(u), b = at.y - float(v);
    const T *row = &atPlaces[first_[triangle]], *low = row + start(n, v) + u,
            *high = row + start(n, v + 1) + u;
    if (a + b <= 1 || u + v + 1 >= n) return (1 - a - b) * low[0] + a * low[1] + b * high[0];
    return (a + b - 1) * high[1] + (1 - b) * low[1] + (1 - a) * high[0];
  }

 private:
  // Place of row v in a net of n parts a side, which has n + 1 - v places in that row.
  static std::uint32_t start(std::uint32_t n, std::uint32_t v) { return v * (n + 1) - v * (v - 1) / 2; }

  std::vector<glm::vec3> positions_, normals_;
  std::vector<std::uint32_t> parts_, first_;  // per triangle
};

}  // namespace sonoskin
