#include "core/skin/gaussian_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace sonoskin {
namespace {

void expectNear(const glm::dvec3& value, const glm::dvec3& expected, double tolerance) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], expected[c], tolerance) << "channel " << c;
}

struct Row {
  double x;
  glm::dvec3 value;
};

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
  const std::vector<Row> rows{{0, {6.285522, 12.590601, 17.272455}},
                              {0.5, {0.130301, 0.171742, 0.087064}},
                              {1, {0.043908, 0.012724, 0.000850}},
                              {2, {0.012694, 0.000179, 0.000058}},
                              {4, {0.001083, 0.000006, 0}}};
  for (const Row& row : rows) expectNear(profileAt(literatureSkin(), row.x), row.value, 1e-6);
}

TEST(GaussianSum, RadiiOfTheLiterature) {
  const GaussianSum skin = literatureSkin();
  expectNear(rootMeanSquareRadius(skin), {1.663, 0.369, 0.223}, 6e-4);
  const std::vector<Row> rows{
      {0.5, {0.694, 0.166, 0.123}}, {0.9, {2.756, 0.580, 0.355}}, {0.99, {5.539, 1.171, 0.638}}};
  for (const Row& row : rows)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(radiusOfEnergy(skin, c, row.x), row.value[c], 6e-4);
}

TEST(GaussianSum, HalfPlane) {
  const std::vector<Row> rows{{-4, {0.006346, 0.000009, 0}},
                              {-2, {0.046455, 0.000341, 0.000028}},
                              {-1, {0.125084, 0.003657, 0.000646}},
                              {-0.5, {0.207122, 0.031601, 0.005737}},
                              {-0.1, {0.362570, 0.243088, 0.183400}},
                              {0, {0.5, 0.5, 0.5}},
                              {0.1, {0.637430, 0.756912, 0.816600}},
                              {0.5, {0.792878, 0.968399, 0.994263}},
                              {1, {0.874916, 0.996343, 0.999354}},
                              {2, {0.953545, 0.999659, 0.999972}},
                              {4, {0.993654, 0.999991, 1}}};
  for (const Row& row : rows) expectNear(halfPlaneResponse(literatureSkin(), row.x), row.value, 1e-6);
}

TEST(GaussianSum, Sinusoid) {
  const std::vector<Row> rows{{1, {0.246760, 0.535189, 0.704304}},
                              {2, {0.358308, 0.784579, 0.900162}},
                              {5, {0.576710, 0.952235, 0.981304}},
                              {10, {0.806286, 0.987015, 0.995169}},
                              {20, {0.938112, 0.996669, 0.998781}}};
  for (const Row& row : rows) expectNear(sinusoidAmplitude(literatureSkin(), row.x), row.value, 1e-6);
}

TEST(GaussianSum, MiddleOfADisc) {
  const std::vector<Row> rows{{0.5, {0.428425, 0.863760, 0.968388}},
                              {1, {0.593700, 0.980320, 0.997091}},
                              {2, {0.806087, 0.998326, 0.999794}},
                              {5, {0.984893, 0.999993, 1}}};
  for (const Row& row : rows) expectNear(energyWithin(literatureSkin(), row.x), row.value, 1e-6);
}

TEST(GaussianSum, ThroughAPlate) {
  const GaussianSum skin = literatureSkin();
  const std::vector<Row> rows{{0.5, {0.5716, 0.1362, 0.0316}},
                              {1, {0.4063, 0.0197, 0.0029}},
                              {2, {0.1939, 0.0017, 0.0002}},
                              {3, {0.0798, 0.0004, 0}}};
  for (const Row& row : rows) expectNear(gaussianTransmittance(skin, row.x), row.value, 6e-5);
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
  expectNear(halfPlaneResponse(point, 1e-6), glm::dvec3(1), 0);
  expectNear(sinusoidAmplitude(point, 0.01), glm::dvec3(1), 0);
  expectNear(gaussianTransmittance(point, 0.1), glm::dvec3(0), 0);
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
