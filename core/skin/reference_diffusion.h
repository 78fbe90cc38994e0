#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/skin/dipole.h"
#include "core/skin/gaussian_sum.h"
#include "core/skin/skin_options.h"
#include "core/skin/skin_surface.h"

namespace sonoskin {

// referenceDiffusion: the light that comes out of every texel of an atlas by integration over the surface, through thin
// parts too: what blurs in the atlas approximate.
//   input    irradiance   per texel, linear, premultiplied by its coverage
//   output   per texel rgb; a: 1 where the surface or its skirt beside it is, else 0. Even light of 1 stays 1 but where it
//            also passes through thin parts. Gaussians that are too narrow for samples on the surface (0.15 mm apart for
//            the literature's: the narrowest) leave the texel's own irradiance.
//   method   samples of the mesh that read the atlas between its texels, in a tree       [Jensen, Buhler 2002; eps 0.05]
//   cost     14,000 mm^2, texels of 0.3 mm: about 8 s of CPU; in proportion to the texels
//   errors   Error: not one irradiance per texel; Cancelled
std::vector<glm::vec4> referenceDiffusion(const SkinSurface& surface, const GaussianSum& profile,
                                          const std::vector<glm::vec4>& irradiance,
                                          const Progress& progress = {});

// The same with the dipole of a medium, which is divided by its total: the albedo colours, the profile spreads.
std::vector<glm::vec4> referenceDiffusion(const SkinSurface& surface, const MediumRgb& medium,
                                          const std::vector<glm::vec4>& irradiance,
                                          const Progress& progress = {});

// The same for the skin of the options: with its medium, or with its Gaussians where no medium stands behind them.
std::vector<glm::vec4> referenceDiffusion(const SkinSurface& surface, const SkinOptions& skin,
                                          const std::vector<glm::vec4>& irradiance,
                                          const Progress& progress = {});

}  // namespace sonoskin
