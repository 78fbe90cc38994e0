#include "core/skin/scatter_profile.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

SkinOptions optionsOf(ScatterProfile profile) {
  SkinOptions options;
  options.profile = profile;
  return options;
}

TEST(ScatterProfile, MediumIsThatOfThePigments) {
  for (ScatterProfile profile : {ScatterProfile::newborn, ScatterProfile::preterm, ScatterProfile::vernix}) {
    const MediumRgb medium = mediumOf(optionsOf(profile)), expected = dermisRgb(*pigmentsOf(profile));
    for (size_t c = 0; c < 3; ++c) EXPECT_EQ(medium[c].absorption, expected[c].absorption);
  }
  EXPECT_FALSE(pigmentsOf(ScatterProfile::adult) || pigmentsOf(ScatterProfile::custom));
}

TEST(ScatterProfile, CustomTakesItsCoefficients) {
  SkinOptions options = optionsOf(ScatterProfile::custom);
  EXPECT_EQ(mediumOf(options)[1].scattering, jensenSkin()[1].scattering) << "the defaults are skin1";
  options.absorption = {0.01, 0.02, 0.03};
  EXPECT_EQ(mediumOf(options)[2].absorption, 0.03);
  for (int k = 1; k <= 6; ++k) {
    options.gaussians = k;
    EXPECT_EQ(fitProfile(options).variances.size(), size_t(k));
    const GaussianSum sum = diffusionOf(options);
    for (int i = 0; i < 6 - k; ++i) EXPECT_EQ(sum.weights[size_t(i)], glm::dvec3(0));
  }
}

// Half of each channel's light leaves within the same radius, whichever way the profile is written.
TEST(ScatterProfile, FitKeepsTheRadii) {
  for (ScatterProfile profile : {ScatterProfile::newborn, ScatterProfile::preterm, ScatterProfile::darker,
                                 ScatterProfile::vernix, ScatterProfile::custom}) {
    const SkinOptions options = optionsOf(profile);
    const DipoleRgb dipoles = makeDipoles(mediumOf(options));
    const GaussianSum sum = diffusionOf(options);
    for (int c = 0; c < 3; ++c)
      for (double share : {0.5, 0.9}) {
        const double r = radiusOfEnergy(sum, c, share);
        const Dipole& d = dipoles[size_t(c)];
        EXPECT_NEAR(reflectanceWithin(d, r) / totalReflectance(d), share, 0.005) << int(profile) << " " << c;
      }
  }
}

TEST(ScatterProfile, WidthScalesTheRadii) {
  SkinOptions options = optionsOf(ScatterProfile::newborn);
  const double radius = radiusOfEnergy(diffusionOf(options), 0, 0.5);
  options.width = 2;
  EXPECT_NEAR(radiusOfEnergy(diffusionOf(options), 0, 0.5), 2 * radius, 1e-9);
}

}  // namespace
}  // namespace sonoskin
