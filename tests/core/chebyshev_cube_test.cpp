#include "core/rbf/global/chebyshev_cube.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin {
namespace {

template <class F>
ChebyshevCube cubeOf(const F& f) {
  std::array<double, ChebyshevCube::kSize> values{};
  for (std::size_t n = 0; n < values.size(); ++n) values[n] = f(ChebyshevCube::place(n));
  return ChebyshevCube(values);
}

const ChebyshevCube::Four kX{-1, -0.3, 0.2, 0.9}, kY{-0.8, 0, 0.5, 1}, kZ{-0.6, -0.1, 0.4, 0.7};

// The largest difference from f on a lattice.
template <class F>
double latticeError(const ChebyshevCube& cube, const F& f) {
  std::array<double, 64> sums{};
  sums.fill(3);  // is added to
  cube.addOnLattice(kX, kY, kZ, sums.data());
  double largest = 0;
  for (std::size_t n = 0; n < 64; ++n)
    largest = std::max(largest, std::abs(sums[n] - 3 - f(glm::dvec3(kX[n % 4], kY[n / 4 % 4], kZ[n / 16]))));
  return largest;
}

// As many nodes as the cube has stand for polynomials of one degree less along every axis.
TEST(ChebyshevCube, ReproducesPolynomials) {
  const auto f = [](const glm::dvec3& p) {
    return 1 + p.x - 2 * p.y * p.z + std::pow(p.x, 5) * std::pow(p.y, 4) * std::pow(p.z, 3) -
           std::pow(p.z, 5);
  };
  const ChebyshevCube cube = cubeOf(f);
  EXPECT_LT(latticeError(cube, f), 1e-13);
  const glm::dvec3 p(0.3, -0.7, 0.5), g = cube.gradient(p);
  EXPECT_NEAR(g.x, 1 + 5 * std::pow(p.x, 4) * std::pow(p.y, 4) * std::pow(p.z, 3), 1e-12);
  EXPECT_NEAR(g.y, -2 * p.z + 4 * std::pow(p.x, 5) * std::pow(p.y, 3) * std::pow(p.z, 3), 1e-12);
  EXPECT_NEAR(g.z, -2 * p.y + 3 * std::pow(p.x, 5) * std::pow(p.y, 4) * p.z * p.z - 5 * std::pow(p.z, 4),
              1e-12);
}

// The farther a centre, the better its share is met.
TEST(ChebyshevCube, MeetsTheDistanceFromAFarCentre) {
  double last = 1;
  for (const double away : {1.5, 2.5, 4.0}) {
    const auto f = [&](const glm::dvec3& p) { return glm::distance(p, glm::dvec3(away, 0.2, -0.4)); };
    const double error = latticeError(cubeOf(f), f);
    EXPECT_LT(error, last / 3);
    last = error;
  }
  EXPECT_LT(last, 1e-4);
}

}  // namespace
}  // namespace sonoskin
