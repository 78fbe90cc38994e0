#include "core/skin/gaussian_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/skin_tables.h"

namespace sonoskin {
namespace {

void expectNear(const glm::dvec3& value, const glm::dvec3& expected, double tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], expected[c], tolerance) << "channel " << c;
}

TEST(GaussianSum, LiteratureIsWhiteAndEveryTermHoldsOne) {
  const GaussianSum skin = literatureSkin();
  glm::dvec3 sum(0);
  for (const glm::dvec3& w : skin.weights) sum += w;
  expectNear(sum, glm::dvec3(1), 1e-15);
  for (double v : skin.variances) {
    GaussianSum one = scaledByWidth(skin, 0);
    one.variances.fill(v);
    const double step = 0.01 * std::sqrt(v);
    double total = 0;
    for (int i = 0; i < 1200; ++i) {
      const double r = step * (i + 0.5);
      total += profileAt(one, r).x * 2 * std::numbers::pi * r * step;
    }
    EXPECT_NEAR(total, 1, 1e-5);
  }
}

TEST(GaussianSum, ProfileOfTheLiterature) {
  const std::vector<test::SkinValue> rows{{0, {6.285522, 12.590601, 17.272455}},
                                          {0.5, {0.130301, 0.171742, 0.087064}},
                                          {1, {0.043908, 0.012724, 0.000850}},
                                          {2, {0.012694, 0.000179, 0.000058}},
                                          {4, {0.001083, 0.000006, 0}}};
  for (const test::SkinValue& row : rows) expectNear(profileAt(literatureSkin(), row.at), row.light, 1e-6);
}

TEST(GaussianSum, RadiiOfTheLiterature) {
  const GaussianSum skin = literatureSkin();
  expectNear(rootMeanSquareRadius(skin), {1.663, 0.369, 0.223}, 6e-4);
  const std::vector<test::SkinValue> rows{
      {0.5, {0.694, 0.166, 0.123}}, {0.9, {2.756, 0.580, 0.355}}, {0.99, {5.539, 1.171, 0.638}}};
  for (const test::SkinValue& row : rows)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(radiusOfEnergy(skin, c, row.at), row.light[c], 6e-4);
}

TEST(GaussianSum, ClosedForms) {
  const GaussianSum skin = literatureSkin();
  for (const test::SkinValue& row : test::kHalfPlane)
    expectNear(halfPlaneResponse(skin, row.at), row.light, 1e-6);
  for (const test::SkinValue& row : test::kSine) expectNear(sinusoidAmplitude(skin, row.at), row.light, 1e-6);
  for (const test::SkinValue& row : test::kDisk) expectNear(energyWithin(skin, row.at), row.light, 1e-6);
}

TEST(GaussianSum, ThroughAPlate) {
  const GaussianSum skin = literatureSkin();
  const std::vector<test::SkinValue> rows{{0.5, {0.5716, 0.1362, 0.0316}},
                                          {1, {0.4063, 0.0197, 0.0029}},
                                          {2, {0.1939, 0.0017, 0.0002}},
                                          {3, {0.0798, 0.0004, 0}}};
  for (const test::SkinValue& row : rows) expectNear(gaussianTransmittance(skin, row.at), row.light, 6e-5);
  EXPECT_NEAR(gaussianTransmittance(skin, 4).x, 0.0329, 6e-5);
  EXPECT_NEAR(gaussianTransmittance(skin, 6).x, 0.0069, 6e-5);
  EXPECT_NEAR(gaussianTransmittance(skin, 10).x, 0.00009, 6e-6);
}

TEST(GaussianSum, WidthScalesEveryLength) {
  const GaussianSum skin = literatureSkin(), wide = scaledByWidth(skin, 2);
  expectNear(energyWithin(wide, 3), energyWithin(skin, 1.5), 1e-15);
  expectNear(profileAt(wide, 3), profileAt(skin, 1.5) / 4.0, 1e-15);
}

TEST(GaussianSum, WidthZeroSpreadsNothing) {
  const GaussianSum point = scaledByWidth(literatureSkin(), 0);
  EXPECT_EQ(point.variances, (std::array<double, 6>{}));
  EXPECT_EQ(point.weights[0], glm::dvec3(1));
  expectNear(halfPlaneResponse(point, -1e-6), glm::dvec3(0), 0);
  expectNear(halfPlaneResponse(point, 0), glm::dvec3(0.5), 0);
  expectNear(halfPlaneResponse(point, 1e-6), glm::dvec3(1), 0);
  expectNear(sinusoidAmplitude(point, 0.01), glm::dvec3(1), 0);
  expectNear(gaussianTransmittance(point, 0.1), glm::dvec3(0), 0);
  expectNear(gaussianTransmittance(point, 0), glm::dvec3(1), 0);
  expectNear(profileAt(point, 0), glm::dvec3(0), 0);
  expectNear(energyWithin(point, 0.1), glm::dvec3(1), 0);
  EXPECT_LT(radiusOfEnergy(point, 0, 0.9), 1e-9);
}

// Far out, and where the share is never reached.
TEST(GaussianSum, RadiiOfAnySize) {
  GaussianSum wide = scaledByWidth(literatureSkin(), 1000);
  EXPECT_NEAR(radiusOfEnergy(wide, 0, 0.5), 1000 * radiusOfEnergy(literatureSkin(), 0, 0.5), 1e-6);
  for (glm::dvec3& w : wide.weights) w *= 0.5;
  const double never = radiusOfEnergy(wide, 0, 0.9);
  EXPECT_TRUE(never >= 1e6 && never < 2e6);
}

TEST(GaussianSum, NormalisedIsWhite) {
  GaussianSum edited = literatureSkin();
  edited.weights[2] = {0.9, 0.1, 3};
  glm::dvec3 sum(0);
  for (const glm::dvec3& w : normalised(edited).weights) sum += w;
  expectNear(sum, glm::dvec3(1), 1e-15);
}

}  // namespace
}  // namespace sonoskin
