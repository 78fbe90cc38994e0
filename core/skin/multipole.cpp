#include "core/skin/multipole.h"

#include <cmath>

namespace sonoskin {
namespace {

// sinh(a q) / sinh(b q) for b > 0, |a| <= b; without overflow, and a / b where q is 0.
double sinhRatio(double a, double b, double q) {
  if (a < 0) return -sinhRatio(-a, b, q);
  if (b * q < 1e-9) return a / b;
  return std::exp((a - b) * q) * std::expm1(-2 * a * q) / std::expm1(-2 * b * q);
}

}  // namespace

Plate plateOf(const ScatteringMedium& medium, double thickness, double s) {
  const Dipole dipole = makeDipole(medium);
  const double q = std::hypot(s, dipole.decay), path = dipole.real;
  const double beyond = dipole.virtualSource - path;  // 2 z_b: both boundary planes lie half of it outside
  const double half = thickness + beyond;             // of the images' period
  const double scale = dipole.albedo / 2;
  return {scale * (sinhRatio(half - path, half, q) + sinhRatio(thickness - path, half, q)),
          scale * (sinhRatio(beyond + path, half, q) + sinhRatio(path, half, q))};
}

Plate onTop(const Plate& upper, const Plate& lower) {
  const double between = 1 - upper.reflectance * lower.reflectance;
  return {upper.reflectance + upper.transmittance * upper.transmittance * lower.reflectance / between,
          upper.transmittance * lower.transmittance / between};
}

}  // namespace sonoskin
