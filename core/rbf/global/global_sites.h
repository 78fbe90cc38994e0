#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace sonoskin {

// Sites: places of a global radial basis function, one array per coordinate for vector code.
struct Sites {
  std::vector<double> x, y, z;

  std::size_t size() const { return x.size(); }
  glm::dvec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void push_back(const glm::dvec3& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
};

// pick: the sites with the given indices, in that order.
Sites pick(const Sites& sites, const std::vector<std::uint32_t>& indices);

// UnitFrame: the shift and scale that bring a box of positions, mm, into [-1, 1]³. Kernels and polynomials then
// have values around 1, which keeps the systems well conditioned.
struct UnitFrame {
  glm::dvec3 centre{0};
  double scale = 1;  // mm

  glm::dvec3 toUnit(const glm::dvec3& p) const { return (p - centre) / scale; }
};

// unitFrame: of positions that are not all at one place.
UnitFrame unitFrame(const Sites& positions);
Sites toUnit(const UnitFrame& frame, const Sites& positions);

// SiteLeaves: sites sorted into leaves of a k-d tree: near each other in order, near each other in space.
struct SiteLeaves {
  std::vector<std::uint32_t> order;  // sites, leaf by leaf
  std::vector<std::size_t> begin;    // of each leaf in `order`, and the end of the last one

  std::size_t count() const { return begin.size() - 1; }
};

// splitIntoLeaves: halves at the median of the longest side until a leaf has at most `most` sites.
//   cost   O(N log N)
SiteLeaves splitIntoLeaves(const Sites& sites, std::size_t most);

}  // namespace sonoskin
