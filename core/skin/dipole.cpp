#include "core/skin/dipole.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sonoskin {
namespace {

constexpr double kPi = std::numbers::pi;

// The source at depth z: its part of 4 pi R_d / alpha'.
double sourceAt(double z, double decay, double r) {
  const double d = std::hypot(r, z);
  return z * (1 + decay * d) * std::exp(-decay * d) / (d * d * d);
}

// The integral of sourceAt over the disc of radius r, divided by 2 pi.
double sourceWithin(double z, double decay, double r) {
  const double d = std::hypot(r, z);
  return std::exp(-decay * z) - z * std::exp(-decay * d) / d;
}

// lineBeside: the integral of R_d along a straight line at distance x. With y = c sinh(t) the integrand falls
// off doubly exponentially, so that equal steps in t converge faster than any power.
double lineBeside(const Dipole& dipole, double x) {
  constexpr int kSteps = 60;
  constexpr double kReach = 9;
  const double c = std::hypot(x, dipole.real);
  double sum = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double t = kReach * i / kSteps;
    sum += diffuseReflectance(dipole, std::hypot(x, c * std::sinh(t))) * c * std::cosh(t);
  }
  return sum * kReach / kSteps;
}

}  // namespace

MediumRgb jensenSkin() {
  return {ScatteringMedium{0.032, 0.74, 1.3}, ScatteringMedium{0.17, 0.88, 1.3},
          ScatteringMedium{0.48, 1.01, 1.3}};
}

double internalReflection(double eta) {
  const double f = -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta;
  return (1 + f) / (1 - f);
}

Dipole makeDipole(const ScatteringMedium& medium) {
  const double transport = medium.absorption + medium.scattering;
  const double real = 1 / transport;
  return {medium.scattering / transport, std::sqrt(3 * medium.absorption * transport), real,
          real * (1 + 4 * internalReflection(medium.eta) / 3)};
}

double diffuseReflectance(const Dipole& dipole, double r) {
  const double below = sourceAt(dipole.real, dipole.decay, r);
  const double above = sourceAt(dipole.virtualSource, dipole.decay, r);
  return dipole.albedo / (4 * kPi) * (below + above);
}

double totalReflectance(const Dipole& dipole) { return reflectanceSpectrum(dipole, 0); }

double reflectanceWithin(const Dipole& dipole, double r) {
  const double below = sourceWithin(dipole.real, dipole.decay, r);
  const double above = sourceWithin(dipole.virtualSource, dipole.decay, r);
  return dipole.albedo / 2 * (below + above);
}

double reflectanceSpectrum(const Dipole& dipole, double s) {
  const double q = std::hypot(s, dipole.decay);
  return dipole.albedo / 2 * (std::exp(-dipole.real * q) + std::exp(-dipole.virtualSource * q));
}

double reflectanceOfHalfPlane(const Dipole& dipole, double x) {
  constexpr int kIntervals = 64;  // Simpson's rule over the lines between the edge and x
  const double step = std::abs(x) / kIntervals;
  double sum = 0;
  for (int i = 0; i <= kIntervals; ++i) {
    const double weight = i == 0 || i == kIntervals ? 1 : i % 2 ? 4 : 2;
    sum += weight * lineBeside(dipole, step * i);
  }
  return totalReflectance(dipole) / 2 + std::copysign(sum * step / 3, x);
}

}  // namespace sonoskin
