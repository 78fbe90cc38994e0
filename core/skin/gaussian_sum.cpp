#include "core/skin/gaussian_sum.h"

#include <cmath>
#include <numbers>

namespace sonoskin {
namespace {

// weighted: sum_i w_ic term(v_i).
template <class Term>
glm::dvec3 weighted(const GaussianSum& sum, const Term& term) {
  glm::dvec3 total(0);
  for (int i = 0; i < GaussianSum::kCount; ++i)
    total += sum.weights[size_t(i)] * term(sum.variances[size_t(i)]);
  return total;
}

}  // namespace

GaussianSum literatureSkin() {
  return {{0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41},
          {glm::dvec3{0.233, 0.455, 0.649}, glm::dvec3{0.100, 0.336, 0.344}, glm::dvec3{0.118, 0.198, 0},
           glm::dvec3{0.113, 0.007, 0.007}, glm::dvec3{0.358, 0.004, 0}, glm::dvec3{0.078, 0, 0}}};
}

GaussianSum scaledByWidth(const GaussianSum& sum, double width) {
  GaussianSum scaled = sum;
  if (width <= 0) {
    scaled.variances.fill(0);
    scaled.weights.fill(glm::dvec3(0));
    scaled.weights[0] = glm::dvec3(1);
    return scaled;
  }
  for (double& v : scaled.variances) v *= width * width;
  return scaled;
}

GaussianSum normalised(const GaussianSum& sum) {
  const glm::dvec3 total = weighted(sum, [](double) { return 1.0; });
  GaussianSum unit = sum;
  for (glm::dvec3& w : unit.weights) w /= total;
  return unit;
}

glm::dvec3 profileAt(const GaussianSum& sum, double r) {
  return weighted(
      sum, [r](double v) { return v > 0 ? std::exp(-r * r / (2 * v)) / (2 * std::numbers::pi * v) : 0; });
}

glm::dvec3 energyWithin(const GaussianSum& sum, double r) {
  return weighted(sum, [r](double v) { return v > 0 ? -std::expm1(-r * r / (2 * v)) : 1; });
}

double radiusOfEnergy(const GaussianSum& sum, int channel, double share) {
  double low = 0, high = 1e-3;
  while (energyWithin(sum, high)[channel] < share && high < 1e6) high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (energyWithin(sum, middle)[channel] < share ? low : high) = middle;
  }
  return high;
}

glm::dvec3 rootMeanSquareRadius(const GaussianSum& sum) {
  return glm::sqrt(weighted(sum, [](double v) { return 2 * v; }));
}

glm::dvec3 halfPlaneResponse(const GaussianSum& sum, double x) {
  const double step = x > 0 ? 1 : x < 0 ? 0 : 0.5;
  return weighted(sum, [=](double v) { return v > 0 ? std::erfc(-x / std::sqrt(2 * v)) / 2 : step; });
}

glm::dvec3 sinusoidAmplitude(const GaussianSum& sum, double period) {
  const double frequency = 2 * std::numbers::pi / period;
  return weighted(sum, [=](double v) { return std::exp(-v * frequency * frequency / 2); });
}

glm::dvec3 gaussianTransmittance(const GaussianSum& sum, double thickness) {
  const double d2 = thickness * thickness;
  return weighted(sum, [=](double v) { return v > 0 ? std::exp(-d2 / (2 * v)) : double(d2 == 0); });
}

}  // namespace sonoskin
