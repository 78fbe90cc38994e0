#include "core/skin/scatter_profile.h"

#include <algorithm>
#include <cassert>

namespace sonoskin {
namespace {

// The literature's variances without the narrowest and with one of 25 mm^2 for the far tail of red.
constexpr std::array<double, 6> kWiderVariances{0.0484, 0.187, 0.567, 1.99, 7.41, 25};

double worst(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

GaussianFit fitToKnownVariances(const DipoleRgb& dipoles) {
  const GaussianFit narrow = fitWeights(dipoles, literatureSkin().variances);
  const GaussianFit wide = fitWeights(dipoles, kWiderVariances);
  return worst(energyDifference(dipoles, wide)) < worst(energyDifference(dipoles, narrow)) ? wide : narrow;
}

}  // namespace

std::optional<Pigments> pigmentsOf(ScatterProfile profile) {
  switch (profile) {
    case ScatterProfile::newborn:
      return Pigments{0.005, 0.010, 0.80, 0.06};
    case ScatterProfile::preterm:
      return Pigments{0.002, 0.035, 0.70, 0.03};
    case ScatterProfile::darker:
      return Pigments{0.03, 0.012, 0.78, 0.06};
    case ScatterProfile::vernix:
      return Pigments{0.002, 0.002, 0.80, 0.03};
    case ScatterProfile::adult:
    case ScatterProfile::custom:
      break;
  }
  return std::nullopt;
}

MediumRgb mediumOf(const SkinOptions& options) {
  if (const auto pigments = pigmentsOf(options.profile)) return dermisRgb(*pigments);
  MediumRgb medium = jensenSkin();
  if (options.profile == ScatterProfile::custom)
    for (size_t c = 0; c < 3; ++c)
      medium[c].absorption = options.absorption[c], medium[c].scattering = options.scattering[c];
  return medium;
}

GaussianFit fitProfile(const SkinOptions& options) {
  assert(options.profile != ScatterProfile::adult);
  const DipoleRgb dipoles = makeDipoles(mediumOf(options));
  return options.profile == ScatterProfile::custom ? fitGaussians(dipoles, options.gaussians)
                                                   : fitToKnownVariances(dipoles);
}

GaussianSum diffusionOf(const SkinOptions& options) {
  const bool adult = options.profile == ScatterProfile::adult;
  return scaledByWidth(adult ? literatureSkin() : asSum(fitProfile(options)), options.width);
}

}  // namespace sonoskin
