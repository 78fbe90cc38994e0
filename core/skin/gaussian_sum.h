#pragma once

#include <array>
#include <glm/glm.hpp>

namespace sonoskin {

// GaussianSum: R_c(r) = sum_i w_ic G(v_i, r), G(v, r) = exp(-r^2 / 2v) / (2 pi v): how far light spreads below a surface,
// in red, green and blue.
//   variances   mm^2, ascending; equal neighbours are allowed and cost no blur
//   weights     per channel they sum to 1: the profile spreads, the albedo colours
struct GaussianSum {
  static constexpr int kCount = 6;
  std::array<double, kCount> variances{};
  std::array<glm::dvec3, kCount> weights{};
};

// literatureSkin: the six Gaussians of three-layered skin.                       [d'Eon, Luebke 2007, GPU Gems 3, ch. 14]
GaussianSum literatureSkin();

}  // namespace sonoskin
