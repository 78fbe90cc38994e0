#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// TriangleLattice: places on a mesh between which values are interpolated: the vertices, and where triangles are too large,
// a net of further ones on each; on slivers pairs of places along the two long sides.
class TriangleLattice {
 public:
  // kMost: places that are enough for any surface; longer sides are allowed where there would be more.
  static constexpr std::size_t kMost = 2'600'000;

  // longest   mm: no side of a part is longer, but for triangles of more than 128 parts a side
  // most      places beside the vertices
  // shown     how many triangles have places: the first ones
  TriangleLattice(const Mesh& mesh, double longest, std::size_t most = kMost,
                  std::size_t shown = std::numeric_limits<std::size_t>::max());

  // placesOf: how many places it would have, vertices included.
  static std::uint64_t placesOf(const Mesh& mesh, double longest,
                                std::size_t shown = std::numeric_limits<std::size_t>::max());

  const std::vector<glm::vec3>& positions() const { return positions_; }
  const std::vector<glm::vec3>& normals() const { return normals_; }

  // value: between the places of a triangle.
  //   weights   of its corners, none negative, sum 1
  template <class T>
  T value(const std::vector<T>& atPlaces, const Triangle& corners, std::uint32_t triangle,
          const glm::vec3& weights) const {
    const Net& net = nets_[triangle];
    if (net.parts <= 1)
      return weights.x * atPlaces[corners[0]] + weights.y * atPlaces[corners[1]] +
             weights.z * atPlaces[corners[2]];
    return net.tip < 3 ? inStrip(&atPlaces[net.first], net, weights)
                       : inNet(&atPlaces[net.first], net.parts, weights);
  }

 private:
  // Net: of a triangle.
  //   tip   of a sliver: the corner between its long sides; 3: it is none
  struct Net {
    std::uint32_t first = 0, parts = 1, tip = 3;

    std::uint64_t places() const {
      if (parts <= 1) return 0;
      return tip < 3 ? 2 * (std::uint64_t(parts) + 1) : (std::uint64_t(parts) + 1) * (parts + 2) / 2;
    }
  };
  static Net netOf(const Mesh& mesh, const Triangle& triangle, double longest);

  // Place of row v in a net of n parts a side, which has n + 1 - v places in that row.
  static std::uint32_t rowStart(std::uint32_t n, std::uint32_t v) { return v * (n + 1) - v * (v - 1) / 2; }

  template <class T>
  static T inNet(const T* places, std::uint32_t n, const glm::vec3& weights) {
    // The part: a square of the net, and which half of it.
    const glm::vec2 at = float(n) * glm::vec2(weights.y, weights.z);
    std::uint32_t u = std::min(std::uint32_t(at.x), n - 1), v = std::min(std::uint32_t(at.y), n - 1 - u);
    float a = at.x - float(u), b = at.y - float(v);
    const T *low = places + rowStart(n, v) + u, *high = places + rowStart(n, v + 1) + u;
    if (a + b <= 1 || u + v + 1 >= n) return (1 - a - b) * low[0] + a * low[1] + b * high[0];
    return (a + b - 1) * high[1] + (1 - b) * low[1] + (1 - a) * high[0];
  }

  // Along the long sides first: straight lines of the same share of the way across run to the tip.
  template <class T>
  static T inStrip(const T* places, const Net& net, const glm::vec3& weights) {
    const float second = weights[int((net.tip + 1) % 3)], third = weights[int((net.tip + 2) % 3)];
    const float along = float(net.parts) * (second + third),
                across = along > 0 ? third / (second + third) : 0;
    const std::uint32_t row = std::min(std::uint32_t(along), net.parts - 1);
    const float part = along - float(row);
    const T* pair = places + 2 * row;
    return (1 - part) * ((1 - across) * pair[0] + across * pair[1]) +
           part * ((1 - across) * pair[2] + across * pair[3]);
  }

  void addPlaces(const Mesh& mesh, const Triangle& triangle, const Net& net);
  void add(const Mesh& mesh, const Triangle& triangle, const glm::vec3& weights);

  std::vector<glm::vec3> positions_, normals_;
  std::vector<Net> nets_;  // per triangle
};

}  // namespace sonoskin
