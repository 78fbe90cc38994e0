#pragma once

#include <optional>

#include "core/skin/chromophores.h"
#include "core/skin/fit_gaussians.h"
#include "core/skin/skin_options.h"

namespace sonoskin {

// pigmentsOf: what newborn, preterm, darker and vernix are made of; none for adult and custom.
std::optional<Pigments> pigmentsOf(ScatterProfile profile);

// mediumOf: what the options' profile is fitted to and what the slab is made of. adult: "skin1" of Jensen
// 2001, for its Gaussians come from a skin of three layers that has no medium of its own; custom: absorption
// and scattering, index 1.3.
MediumRgb mediumOf(const SkinOptions& options);

// fitProfile: the Gaussians of the options' medium, width 1: six, for custom `gaussians` of them.
//   precondition   profile is not adult
GaussianFit fitProfile(const SkinOptions& options);

// diffusionOf: the options' profile, scaled by their width. adult: literatureSkin.
GaussianSum diffusionOf(const SkinOptions& options);

}  // namespace sonoskin
