#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/skin/diffusion_target.h"
#include "core/skin/gaussian_sum.h"
#include "core/skin/surface_samples.h"

namespace sonoskin {

// DiffusedLevels: E_i of each Gaussian of a sum.
using DiffusedLevels = std::array<glm::vec3, GaussianSum::kCount>;

// sumOfLevels: sum_i w_i E_i.
glm::vec3 sumOfLevels(const GaussianSum& profile, const DiffusedLevels& levels);

// isResolved: whether samples with this spacing can tell a Gaussian from none at all.
inline bool isResolved(double variance, double spacing) { return variance > 1.5 * spacing * spacing; }

// bruteForceDiffusion: the light at the targets, straight from the integral over the surface: the truth that everything
// faster is held against.
//   input    irradiance   per sample
//   output   E_i per target. Gaussians that the samples do not resolve leave the target's own irradiance.
//   solves   E_i(x) = sum_j A_j G(v_i, |x - x_j|) E_j / sum_j A_j G(v_i, |x - x_j|), over samples within four widths; the
//            lower sum is over local samples always: it removes the unevenness of the samples and the surface's
//            borders, but not the light through thin parts                                    [theory/skin.md, 6.1]
//   cost     a target with 0.11 mm between samples: 0.4 ms on one core
//   errors   Error: not one irradiance per sample; Cancelled
std::vector<DiffusedLevels> bruteForceDiffusion(const SurfaceSamples& samples,
                                                std::span<const glm::vec3> irradiance,
                                                const GaussianSum& profile,
                                                std::span<const DiffusionTarget> targets, Reach reach,
                                                const Progress& progress = {});

}  // namespace sonoskin
