#include "core/rbf/global/chebyshev_cube.h"

#include <cmath>
#include <numbers>

namespace sonoskin {
namespace {

constexpr std::size_t kNodes = ChebyshevCube::kNodes;
using Row = ChebyshevCube::Row;

double node(std::size_t k) { return std::cos((double(k) + 0.5) * std::numbers::pi / double(kNodes)); }

// T_n(x).
Row polynomials(double x) {
  Row t{1, x};
  for (std::size_t n = 2; n < kNodes; ++n) t[n] = 2 * x * t[n - 1] - t[n - 2];
  return t;
}

// T_n'(x) = n U_{n-1}(x).
Row derivatives(double x) {
  Row u{1, 2 * x}, result{};
  for (std::size_t n = 2; n < kNodes; ++n) u[n] = 2 * x * u[n - 1] - u[n - 2];
  for (std::size_t n = 1; n < kNodes; ++n) result[n] = double(n) * u[n - 1];
  return result;
}

// Values at the nodes to coefficients, along one axis of the cube.
void transform(std::array<double, ChebyshevCube::kSize>& v, std::size_t stride) {
  for (std::size_t first = 0; first < v.size(); ++first) {
    if (first / stride % kNodes != 0) continue;
    Row coefficients{};
    for (std::size_t k = 0; k < kNodes; ++k) {
      const Row t = polynomials(node(k));
      for (std::size_t n = 0; n < kNodes; ++n)
        coefficients[n] += (n == 0 ? 1.0 : 2.0) / double(kNodes) * t[n] * v[first + k * stride];
    }
    for (std::size_t n = 0; n < kNodes; ++n) v[first + n * stride] = coefficients[n];
  }
}

// Σ_n v_n t_n of consecutive values.
double dot(const double* v, const Row& t) {
  double sum = 0;
  for (std::size_t n = 0; n < kNodes; ++n) sum += v[n] * t[n];
  return sum;
}

}  // namespace

glm::dvec3 ChebyshevCube::place(std::size_t n) {
  return {node(n % kNodes), node(n / kNodes % kNodes), node(n / kNodes / kNodes)};
}

ChebyshevCube::ChebyshevCube(const std::array<double, kSize>& values) : coefficients_(values) {
  transform(coefficients_, 1);
  transform(coefficients_, kNodes);
  transform(coefficients_, kNodes * kNodes);
}

// Axis by axis: first sums along x, then of those along y, then along z.
void ChebyshevCube::addOnLattice(const Four& x, const Four& y, const Four& z, double* sums) const {
  std::array<Row, 4> ty, tz;
  for (std::size_t i = 0; i < 4; ++i) ty[i] = polynomials(y[i]), tz[i] = polynomials(z[i]);
  for (std::size_t i = 0; i < 4; ++i) {
    const Row tx = polynomials(x[i]);
    std::array<Row, 4> alongY{};  // by j, of each order along z
    for (std::size_t c = 0; c < kNodes; ++c) {
      Row alongX{};
      for (std::size_t b = 0; b < kNodes; ++b) alongX[b] = dot(&coefficients_[kNodes * (b + kNodes * c)], tx);
      for (std::size_t j = 0; j < 4; ++j) alongY[j][c] = dot(alongX.data(), ty[j]);
    }
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) sums[i + 4 * j + 16 * k] += dot(alongY[j].data(), tz[k]);
  }
}

glm::dvec3 ChebyshevCube::gradient(const glm::dvec3& p) const {
  const Row tx = polynomials(p.x), ty = polynomials(p.y), tz = polynomials(p.z);
  const Row dx = derivatives(p.x), dy = derivatives(p.y), dz = derivatives(p.z);
  glm::dvec3 sum(0);
  for (std::size_t c = 0; c < kNodes; ++c) {
    Row valueX{}, slopeX{};
    for (std::size_t b = 0; b < kNodes; ++b) {
      const double* v = &coefficients_[kNodes * (b + kNodes * c)];
      valueX[b] = dot(v, tx);
      slopeX[b] = dot(v, dx);
    }
    const double valueY = dot(valueX.data(), ty);
    sum += glm::dvec3(dot(slopeX.data(), ty) * tz[c], dot(valueX.data(), dy) * tz[c], valueY * dz[c]);
  }
  return sum;
}

}  // namespace sonoskin
