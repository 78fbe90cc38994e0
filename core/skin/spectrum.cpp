#include "core/skin/spectrum.h"

#include <cmath>

namespace sonoskin {
namespace {

// A bell with one width on either side.
double lobe(double x, double centre, double left, double right) {
  const double t = (x - centre) / (x < centre ? left : right);
  return std::exp(-t * t / 2);
}

glm::dvec3 colourMatching(double nm) {
  return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
              0.065 * lobe(nm, 501.1, 20.4, 26.2),
          0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
          1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

glm::dvec3 rec709(const glm::dvec3& xyz) {
  return {3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
          0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z};
}

std::array<glm::dvec3, kWavelengths> computeWeights() {
  std::array<glm::dvec3, kWavelengths> weights;
  glm::dvec3 white(0);
  for (int i = 0; i < kWavelengths; ++i) white += weights[size_t(i)] = rec709(colourMatching(wavelength(i)));
  for (glm::dvec3& w : weights) w /= white;
  return weights;
}

}  // namespace

const std::array<glm::dvec3, kWavelengths>& spectralWeights() {
  static const std::array<glm::dvec3, kWavelengths> weights = computeWeights();
  return weights;
}

glm::dvec3 linearColour(const Spectrum& reflectance) {
  glm::dvec3 colour(0);
  for (size_t i = 0; i < kWavelengths; ++i) colour += spectralWeights()[i] * reflectance[i];
  return colour;
}

}  // namespace sonoskin
