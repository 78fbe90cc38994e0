#pragma once

#include <array>
#include <glm/glm.hpp>

namespace sonoskin {

// ChebyshevCube: a smooth function in a cube, as a sum of products of Chebyshev polynomials along the three axes that
// meets it at kNodes³ places. Coordinates are relative to the cube: [-1, 1]³.
class ChebyshevCube {
 public:
  static constexpr std::size_t kNodes = 6;
  static constexpr std::size_t kSize = kNodes * kNodes * kNodes;
  using Row = std::array<double, kNodes>;

  // place: where the function has to be known, n in [0, kSize).
  static glm::dvec3 place(std::size_t n);

  // values   at the places, in their order
  explicit ChebyshevCube(const std::array<double, kSize>& values);

  // addOnLattice: adds the function's values at (x[i], y[j], z[k]) to sums[i + 4 j + 16 k].
  using Four = std::array<double, 4>;
  void addOnLattice(const Four& x, const Four& y, const Four& z, double* sums) const;

  glm::dvec3 gradient(const glm::dvec3& p) const;

 private:
  std::array<double, kSize> coefficients_{};
};

}  // namespace sonoskin
