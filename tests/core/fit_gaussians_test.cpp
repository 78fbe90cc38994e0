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
