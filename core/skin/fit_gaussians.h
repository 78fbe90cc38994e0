#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/skin/dipole.h"
#include "core/skin/gaussian_sum.h"

namespace sonoskin {

// GaussianFit: a sum of Gaussians in place of dipoles.
//   variances   mm^2, ascending, shared by the channels
//   weights     >= 0, each channel's sum is 1: they are shares of the dipole's total
//   error       relative L2 with weight r: sqrt(int r (R - fit)^2 dr / int r R^2 dr)
struct GaussianFit {
  std::vector<double> variances;
  std::vector<glm::dvec3> weights;
  glm::dvec3 error{0};
};

using DipoleRgb = std::array<Dipole, 3>;
DipoleRgb makeDipoles(const MediumRgb& medium);

// fitWeights: the best weights for given variances, 1 to 8 of them.
GaussianFit fitWeights(const DipoleRgb& dipoles, std::span<const double> variances);

// fitGaussians: the best `count` variances, 1 to 6, and their weights.                    [d'Eon, Luebke 2007]
// Ours: every integral of the fit has a closed form, so that no grid of distances limits or spoils it.
//   method   Nelder-Mead on the logarithms of the variances, a short one from each of six starts, then a long
//            one from the best
//   cost     1 to 10 ms
GaussianFit fitGaussians(const DipoleRgb& dipoles, int count);

// asSum: the fit with terms of no weight added in front until there are six.
GaussianSum asSum(const GaussianFit& fit);

// energyDifference: L1: the energy that the fit puts in another place, as a share of the total, per channel.
glm::dvec3 energyDifference(const DipoleRgb& dipoles, const GaussianFit& fit);

}  // namespace sonoskin
