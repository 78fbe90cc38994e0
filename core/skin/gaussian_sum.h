#pragma once

#include <array>
#include <glm/glm.hpp>

namespace sonoskin {

// GaussianSum: R_c(r) = sum_i w_ic G(v_i, r), G(v, r) = exp(-r^2 / 2v) / (2 pi v): how far light spreads
// below a surface, in red, green and blue.
//   variances   mm^2, ascending; equal neighbours are allowed and cost no blur; 0: a point, no spread at all
//   weights     per channel they sum to 1: the profile spreads, the albedo colours
struct GaussianSum {
  static constexpr int kCount = 6;
  std::array<double, kCount> variances{};
  std::array<glm::dvec3, kCount> weights{};
};

// literatureSkin: the six Gaussians of three-layered skin.           [d'Eon, Luebke 2007, GPU Gems 3, ch. 14]
GaussianSum literatureSkin();

// scaledByWidth: the same profile, `width` times as wide; 0: everything in a first term of variance 0.
GaussianSum scaledByWidth(const GaussianSum& sum, double width);

// normalised: each channel's weights divided by their sum, which must be positive.
GaussianSum normalised(const GaussianSum& sum);

// profileAt: R_c at the distance r, mm, in 1/mm^2; terms of variance 0 are left out.
glm::dvec3 profileAt(const GaussianSum& sum, double r);

// energyWithin: share of the light that leaves within r mm; also what the middle of a lit disc of that radius
// shows.
glm::dvec3 energyWithin(const GaussianSum& sum, double r);

// radiusOfEnergy: the radius, mm, within which that share (0 .. 1) of a channel's light leaves.
double radiusOfEnergy(const GaussianSum& sum, int channel, double share);

// rootMeanSquareRadius: sqrt(2 sum w v), mm.
glm::dvec3 rootMeanSquareRadius(const GaussianSum& sum);

// halfPlaneResponse: what a plate that is lit where x > 0 shows at x mm: sum w erfc(-x / sqrt(2v)) / 2.
glm::dvec3 halfPlaneResponse(const GaussianSum& sum, double x);

// sinusoidAmplitude: what is left of stripes of that period, mm: sum w exp(-2 pi^2 v / period^2).
glm::dvec3 sinusoidAmplitude(const GaussianSum& sum, double period);

// gaussianTransmittance: even light through that thickness, mm: sum w exp(-d^2 / 2v).    [d'Eon, Luebke 2007]
//   The exponent has 2v, for R(sqrt(r^2 + d^2)) = sum w exp(-d^2 / 2v) G(v, r).
glm::dvec3 gaussianTransmittance(const GaussianSum& sum, double thickness);

}  // namespace sonoskin
