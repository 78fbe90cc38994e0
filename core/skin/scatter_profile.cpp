#include "core/skin/scatter_profile.h"

#include <cassert>

namespace sonoskin {
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
  const int count = options.profile == ScatterProfile::custom ? options.gaussians : GaussianSum::kCount;
  return fitGaussians(makeDipoles(mediumOf(options)), count);
}

GaussianSum diffusionOf(const SkinOptions& options) {
  const bool adult = options.profile == ScatterProfile::adult;
  return scaledByWidth(adult ? literatureSkin() : asSum(fitProfile(options)), options.width);
}

}  // namespace sonoskin
