#include "core/skin/skin_material.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/skin/chromophores.h"
#include "core/skin/multipole.h"

namespace sonoskin {
namespace {

constexpr std::array kProfiles{ScatterProfile::adult,  ScatterProfile::newborn, ScatterProfile::preterm,
                               ScatterProfile::darker, ScatterProfile::vernix,  ScatterProfile::custom};

glm::vec3 entry(const PigmentTable& table, int x, int y, int z) {
  return table.albedo.at(size_t((z * PigmentTable::kBlood + y) * PigmentTable::kMelanin + x));
}

TEST(SkinMaterial, EveryProfileIsWhiteAndAscending) {
  for (ScatterProfile profile : kProfiles)
    for (double width : {0.0, 0.5, 1.0}) {
      SkinOptions options;
      options.profile = profile;
      options.width = width;
      options.gaussians = 3;
      const GaussianSum sum = makeSkinMaterial(options).diffusion;
      glm::dvec3 total(0);
      for (size_t i = 0; i < 6; ++i) {
        total += sum.weights[i];
        EXPECT_GE(sum.variances[i], sum.variances[i == 0 ? 0 : i - 1]);
        for (int c = 0; c < 3; ++c) EXPECT_GE(sum.weights[i][c], 0);
      }
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(total[c], 1, 1e-12);
    }
}

TEST(SkinMaterial, AdultIsTheLiterature) {
  const GaussianSum sum = makeSkinMaterial({}).diffusion;
  EXPECT_EQ(sum.variances, literatureSkin().variances);
  EXPECT_EQ(sum.weights, literatureSkin().weights);
}

TEST(SkinMaterial, PigmentsAreTheAlbedo) {
  SkinOptions options;
  options.epidermis = 0.04;
  const PigmentTable table = makeSkinMaterial(options).pigments;
  ASSERT_EQ(table.albedo.size(), size_t(32 * 32 * 5));
  const double melanin = 0.001 * std::pow(200.0, 11 / 31.0), blood = 0.001 * std::pow(200.0, 17 / 31.0);
  const glm::dvec3 expected = skinAlbedo({melanin, blood, 0.75, 0.04});
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(entry(table, 11, 17, 3)[c], expected[c], 1e-6);
  for (const glm::vec3& albedo : table.albedo)
    for (int c = 0; c < 3; ++c) {
      EXPECT_GE(albedo[c], 0.0f);
      EXPECT_LE(albedo[c], 1.0f);
    }
}

TEST(SkinMaterial, OtherColoursAreOneColour) {
  for (SkinColour colour : {SkinColour::amber, SkinColour::clay, SkinColour::plain}) {
    SkinOptions options;
    options.colour = colour;
    const PigmentTable table = makeSkinMaterial(options).pigments;
    ASSERT_EQ(table.albedo.size(), size_t(32 * 32 * 5));
    for (const glm::vec3& albedo : table.albedo) EXPECT_EQ(albedo, table.albedo[0]);
  }
}

TEST(SkinMaterial, TransmittanceIsThePlatesOverTheReflectance) {
  const SkinMaterial material = makeSkinMaterial({});
  ASSERT_EQ(material.transmittance.size(), size_t(SkinMaterial::kSteps));
  const int step = 51;  // 8 mm
  for (int c = 0; c < 3; ++c) {
    const ScatteringMedium medium = jensenSkin()[size_t(c)];
    const double expected = plateOf(medium, 8).transmittance / totalReflectance(makeDipole(medium));
    EXPECT_NEAR(material.transmittance[step][c], expected, 1e-6);
    EXPECT_EQ(material.transmittance[0][c], material.transmittance[12][c]) << "constant below 2 mm";
    EXPECT_GT(material.transmittance[12][c], material.transmittance[14][c]);
  }
}

TEST(SkinMaterial, TransmittanceFallsWithThickness) {
  for (ScatterProfile profile : kProfiles) {
    SkinOptions options;
    options.profile = profile;
    const auto table = makeSkinMaterial(options).transmittance;
    for (size_t i = 0; i < table.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        EXPECT_TRUE(std::isfinite(table[i][c]) && table[i][c] >= 0);
        EXPECT_LE(table[i][c], table[i == 0 ? 0 : i - 1][c]);
      }
  }
}

// The corners of what the options allow: nothing there may be infinite.
TEST(SkinMaterial, ExtremesAreFinite) {
  for (double absorption : {0.0001, 20.0})
    for (double scattering : {0.01, 50.0})
      for (int gaussians : {1, 6}) {
        SkinOptions options;
        options.profile = ScatterProfile::custom;
        options.absorption.fill(absorption);
        options.scattering = {scattering, 0.7, 1};
        options.gaussians = gaussians;
        const SkinMaterial material = makeSkinMaterial(options);
        for (double v : material.diffusion.variances) EXPECT_TRUE(std::isfinite(v) && v > 0);
        for (const glm::dvec3& w : material.diffusion.weights)
          for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(w[c]));
        for (const glm::vec3& t : material.transmittance)
          for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(t[c]));
      }
}

}  // namespace
}  // namespace sonoskin
