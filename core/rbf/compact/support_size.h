#pragma once

#include <functional>
#include <optional>

#include "core/rbf/compact/neighbourhood.h"

namespace sonoskin {

// SupportRule: what decides the size of supports.
//   smallest   σ_min, mm
//   largest    σ_max, mm
//   diagonal   L, mm
//   smoothness T_sa
struct SupportRule {
  double smallest = 1, largest = 1, diagonal = 1, smoothness = 1e-4;

  // atNoise: the rule for a place whose points lie `noise` mm off, one by one. The second term of E_SA then is the
  // variance of a fit to points whose errors belong together over a resolution cell, and E_SA the expected squared error.
  SupportRule atNoise(double noise) const {
    constexpr double kResolution = 0.053;  // of the smallest support; calibrated on simulated and real scans
    SupportRule rule = *this;
    rule.smoothness = smoothness / 2e-5 * kResolution * smallest * noise / diagonal;
    return rule;
  }

  // E_SA = E_local² + (T_sa L / σ)²                                  [Ohtake et al. 2004; thesis 3.20]
  //   meanSquare   mean squared distance of the points from the quadric, (L E_local)², mm²
  double error(double meanSquare, double sigma) const {
    const double fit = meanSquare / (diagonal * diagonal), size = smoothness * diagonal / sigma;
    return fit + size * size;
  }
};

// firstMinimum: the first local minimum of a function sampled at σ_k = smallest 2^(k/2), then refined by two
// parabola steps in ln σ.
//   error      gives E(σ), or nothing where there are too few points; sampled up to `reach`
//   output     σ of the minimum; `reach` if the function falls up to there and reach >= largest; else nothing: a
//              larger reach is needed
//   note       the bracket of a minimum at σ_k is (σ_{k-1}, σ_{k+1}): it may lie on either side of a sample
std::optional<double> firstMinimum(const std::function<std::optional<double>(double sigma)>& error,
                                   double smallest, double reach, double largest);

// FittedCentre: a support with its quadric.
struct FittedCentre {
  std::uint32_t point = 0;  // sorted point at its centre
  double sigma = 0;         // support, mm
  Frame frame;
  LocalFit fit;
};

// fitCentre: the support at point `centre` that balances detail and noise, and its quadric.
//   hint      support of a centre that covers the point, or 0; it saves time only
//   scratch   left with the points in the support selected
//   cost      6 to 10 fits; 50 to 200 us
FittedCentre fitCentre(const SortedPoints& points, std::size_t centre, const SupportRule& rule, double hint,
                       Neighbourhood& scratch);

// SupportValues: the points that a support covers, with φ and φ g there.
struct SupportValues {
  std::vector<std::uint32_t> points;
  std::vector<float> phi, weighted;

  // take: what the centre gives at the points that `selected` has selected; memory is used again.
  void take(const FittedCentre& centre, const Neighbourhood& selected);
};

}  // namespace sonoskin
