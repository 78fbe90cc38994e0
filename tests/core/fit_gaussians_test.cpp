#include "core/skin/fit_gaussians.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/skin/chromophores.h"

namespace sonoskin {
namespace {

DipoleRgb skin() { return makeDipoles(jensenSkin()); }

DipoleRgb secondSkin() {
  return makeDipoles(
      {ScatteringMedium{0.013, 1.09}, ScatteringMedium{0.070, 1.59}, ScatteringMedium{0.145, 1.79}});
}

void expectWhite(const GaussianFit& fit) {
  glm::dvec3 sum(0);
  for (const glm::dvec3& w : fit.weights) sum += w;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], 1, 1e-12);
}

TEST(FitGaussians, ErrorsForSkin) {
  const std::array<glm::dvec3, 6> published{{{0.521, 0.419, 0.716},
                                             {0.179, 0.123, 0.156},
                                             {0.0498, 0.0379, 0.0384},
                                             {0.0170, 0.0100, 0.0114},
                                             {0.0058, 0.0028, 0.0040},
                                             {0.0021, 0.0013, 0.0014}}};
  for (int k = 1; k <= 6; ++k) {
    const GaussianFit fit = fitGaussians(skin(), k);
    ASSERT_EQ(fit.variances.size(), size_t(k));
    expectWhite(fit);
    for (int c = 0; c < 3; ++c)
      EXPECT_LE(fit.error[c], 1.5 * published[size_t(k - 1)][c]) << k << " terms, channel " << c;
  }
}

TEST(FitGaussians, ErrorsForTheSecondSkin) {
  const std::array<glm::dvec3, 4> published{
      {{0.055, 0.039, 0.040}, {0.019, 0.014, 0.014}, {0.0087, 0.0039, 0.0054}, {0.0030, 0.0022, 0.0021}}};
  for (int k = 3; k <= 6; ++k) {
    const GaussianFit fit = fitGaussians(secondSkin(), k);
    for (int c = 0; c < 3; ++c)
      EXPECT_LE(fit.error[c], 1.5 * published[size_t(k - 3)][c]) << k << " terms, channel " << c;
  }
}

// max r |R - fit| / max r R
glm::dvec3 largestError(const DipoleRgb& dipoles, const GaussianFit& fit) {
  glm::dvec3 most(0), largest(0);
  for (double r = 0.002; r < 30; r *= 1.01)
    for (int c = 0; c < 3; ++c) {
      const Dipole& d = dipoles[size_t(c)];
      const double target = diffuseReflectance(d, r),
                   fitted = totalReflectance(d) * profileAt(asSum(fit), r)[c];
      most[c] = std::max(most[c], r * std::abs(target - fitted));
      largest[c] = std::max(largest[c], r * target);
    }
  return most / largest;
}

TEST(FitGaussians, OtherMeasuresForSkin) {
  const std::array<glm::dvec3, 6> largest{{{0.69, 0.42, 0.73},
                                           {0.29, 0.20, 0.18},
                                           {0.088, 0.050, 0.042},
                                           {0.028, 0.013, 0.013},
                                           {0.010, 0.004, 0.005},
                                           {0.0038, 0.0021, 0.0018}}};
  const std::array<glm::dvec3, 6> energy{{{0.635, 0.418, 0.843},
                                          {0.335, 0.212, 0.195},
                                          {0.138, 0.088, 0.061},
                                          {0.059, 0.032, 0.020},
                                          {0.025, 0.010, 0.008},
                                          {0.0107, 0.0050, 0.0033}}};
  for (int k = 1; k <= 6; ++k) {
    const GaussianFit fit = fitGaussians(skin(), k);
    const size_t row = size_t(k - 1);
    for (int c = 0; c < 3; ++c) {
      EXPECT_LE(largestError(skin(), fit)[c], 1.5 * largest[row][c]) << k;
      EXPECT_LE(energyDifference(skin(), fit)[c], 1.5 * energy[row][c]) << k;
    }
  }
}

TEST(FitGaussians, OneChannelAlone) {
  const std::array<std::array<double, 3>, 3> published{
      {{0.067, 0.038, 0.026}, {0.0164, 0.0080, 0.0049}, {0.0046, 0.0019, 0.0010}}};
  for (int k = 2; k <= 4; ++k)
    for (size_t c = 0; c < 3; ++c) {
      const Dipole d = skin()[c];
      EXPECT_NEAR(fitGaussians({d, d, d}, k).error.x, published[size_t(k - 2)][c], 6e-4) << k << " " << c;
    }
}

TEST(FitGaussians, SixWeightsOfSkin) {
  const GaussianFit fit = fitGaussians(skin(), 6);
  const std::array<glm::dvec3, 6> published{{{0, 0.0065, 0.1150},
                                             {0.0190, 0.1503, 0.4015},
                                             {0.1698, 0.3709, 0.3566},
                                             {0.2980, 0.3348, 0.1251},
                                             {0.3005, 0.1375, 0.0007},
                                             {0.2128, 0, 0.0011}}};
  const std::array<double, 6> variances{0.0745, 0.201, 0.547, 1.67, 6.21, 25.5};
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(fit.variances[i] / variances[i], 1, 0.005);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(fit.weights[i][c], published[i][c], 2e-3) << i << " " << c;
  }
}

TEST(FitGaussians, OnGivenVariances) {
  const std::array<double, 6> wide{0.0484, 0.187, 0.567, 1.99, 7.41, 25};
  const auto expectEnergy = [](const DipoleRgb& dipoles, std::span<const double> variances,
                               const glm::dvec3& published) {
    const glm::dvec3 moved = energyDifference(dipoles, fitWeights(dipoles, variances));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(moved[c], published[c], 1e-3) << c;
  };
  const auto narrow = literatureSkin().variances;
  expectEnergy(skin(), narrow, {0.148, 0.006, 0.018});
  expectEnergy(skin(), wide, {0.015, 0.006, 0.018});
  expectEnergy(makeDipoles(dermisRgb({0.005, 0.025, 0.70, 0.06})), narrow, {0.017, 0.106, 0.148});
}

TEST(FitGaussians, ShorterSumsAreFilledInFront) {
  const GaussianFit fit = fitGaussians(skin(), 2);
  const GaussianSum sum = asSum(fit);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(sum.variances[i], fit.variances[0]);
    EXPECT_EQ(sum.weights[i], glm::dvec3(0));
  }
  EXPECT_EQ(sum.weights[5], fit.weights[1]);
}

TEST(FitGaussians, NewbornOnTheLiteraturesVariances) {
  const DipoleRgb newborn = makeDipoles(dermisRgb({0.005, 0.010, 0.80, 0.06}));
  const GaussianFit fit = fitWeights(newborn, literatureSkin().variances);
  const std::array<glm::dvec3, 6> published{{{0.004, 0.031, 0.113},
                                             {0.199, 0.505, 0.663},
                                             {0.279, 0.222, 0},
                                             {0.182, 0.238, 0.224},
                                             {0.263, 0, 0},
                                             {0.073, 0.004, 0}}};
  for (size_t i = 0; i < 6; ++i) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(fit.weights[i][c], published[i][c], 6e-4) << i << " " << c;
  }
  const glm::dvec3 l1 = energyDifference(newborn, fit);
  EXPECT_NEAR(l1.x, 0.016, 6e-4);
  EXPECT_NEAR(l1.y, 0.056, 6e-4);
  EXPECT_NEAR(l1.z, 0.125, 6e-4);
}

}  // namespace
}  // namespace sonoskin
