#include "core/rbf/compact/support_size.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/rbf/compact/centres.h"
#include "core/rbf/compact/csrbf_model.h"
#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

TEST(SupportSize, FindsTheFirstMinimum) {
  // Minima near 3 (the first) and 40 (deeper).
  const auto error = [](double s) -> std::optional<double> {
    const double x = std::log(s);
    return std::pow(x - std::log(3), 2) * (std::pow(x - std::log(40), 2) + 0.1) - 0.02 * x;
  };
  double fine = 1;
  for (double s = 1; error(s * 1.001) < error(s); s *= 1.001) fine = s;
  const std::optional<double> found = firstMinimum(error, 1, 100, 100);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found / fine, 1, 0.05);
}

TEST(SupportSize, AsksForMoreReachUntilTheErrorRises) {
  const auto falling = [](double s) -> std::optional<double> { return 1 / s; };
  EXPECT_FALSE(firstMinimum(falling, 1, 10, 50));
  EXPECT_EQ(firstMinimum(falling, 1, 50, 50), 50);
  const auto nothing = [](double) -> std::optional<double> { return std::nullopt; };
  EXPECT_FALSE(firstMinimum(nothing, 1, 50, 50));
}

// On a plane there is no local error, so the support is as large as it may be.
TEST(SupportSize, APlaneGetsTheLargestSupport) {
  const SortedPoints points = sortPoints(planePoints(60), {});
  SupportRule rule = supportRule(points, {});
  rule.largest = 12;
  Neighbourhood scratch;
  const FittedCentre centre = fitCentre(points, points.size() / 2, rule, 0, scratch);
  EXPECT_EQ(centre.sigma, rule.largest);
  EXPECT_LT(std::sqrt(centre.fit.meanSquare), 1e-5);
  EXPECT_NEAR(centre.frame.normal.z, 1, 1e-6f);
}

// Derived law of a noise-free sphere of radius R: (L E_local)² = 5.3577e-4 σ⁸ / (64 R⁶).
TEST(SupportSize, TheErrorOfASphereFollowsItsLaw) {
  const double radius = 100;
  const SortedPoints points = sortPoints(spherePoints(200000, radius), {});
  Neighbourhood scratch;
  for (const double sigma : {20.0, 30.0}) {
    scratch.gather(points, 1234, float(sigma));
    scratch.project(frameAround(scratch.meanNormal(float(sigma))), 1);
    const double found = fitQuadric(scratch.within(float(sigma)), sigma).meanSquare;
    const double law = 5.3577e-4 * std::pow(sigma, 8) / (64 * std::pow(radius, 6));
    EXPECT_NEAR(found / law, 1, 0.05) << sigma;
  }
}

// The same law gives the support: σ* = (16 T_sa² R⁶ L⁴ / 5.3577e-4)^(1/10).
TEST(SupportSize, TheSupportOnASphereFollowsItsLaw) {
  const double radius = 100;
  const SortedPoints points = sortPoints(spherePoints(100000, radius), {});
  SupportRule rule = supportRule(points, {});
  rule.largest = 60;
  Neighbourhood scratch;
  for (const double smoothness : {1e-6, 4e-6, 1e-5}) {
    rule.smoothness = smoothness;
    const double law = std::pow(
        16 * smoothness * smoothness * std::pow(radius, 6) * std::pow(rule.diagonal, 4) / 5.3577e-4, 0.1);
    EXPECT_NEAR(fitCentre(points, 777, rule, 0, scratch).sigma / law, 1, 0.1) << smoothness;
    EXPECT_NEAR(fitCentre(points, 777, rule, law, scratch).sigma / law, 1, 0.1) << smoothness;
  }
}

TEST(SupportSize, EverySupportHoldsEnoughPoints) {
  const SortedPoints points = sortPoints(spherePoints(40, 10, 0.3), {});
  const SupportRule rule = supportRule(points, {});
  Neighbourhood scratch;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double sigma = fitCentre(points, i, rule, 0, scratch).sigma;
    EXPECT_GE(scratch.countWithin(float(sigma)), kMinPointsInSupport);
  }
}

// Points of an opposite sheet stay in the fit and in the error, but not in the normal.
TEST(SupportSize, AThinWallShrinksTheSupportButKeepsTheNormal) {
  SurfacePoints wall = planePoints(60);
  const std::size_t count = wall.size();
  for (std::size_t i = 0; i < count; ++i) {
    wall.positions.push_back(wall.positions[i] - glm::vec3(0, 0, 4));
    wall.normals.push_back({0, 0, -1});
    wall.confidence.push_back(1);
  }
  const SortedPoints points = sortPoints(wall, {});
  SupportRule rule = supportRule(points, {});
  rule.largest = 20;
  Neighbourhood scratch;
  std::size_t middle = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.nz[i] > 0 && glm::distance(points.position(i), {30, 30, 0}) < 1) middle = i;
  const FittedCentre centre = fitCentre(points, middle, rule, 0, scratch);
  EXPECT_LT(centre.sigma, 8);
  EXPECT_NEAR(centre.frame.normal.z, 1, 1e-4f);
}

// A place whose points are known to be noisier gets larger supports, and the fit is no rougher for it.
TEST(MeasuredNoise, MakesSupportsLargerWhereThereIsMore) {
  SurfacePoints points = spherePoints(8000, 10, 0.02);
  for (const glm::vec3& p : points.positions) points.noise.push_back(p.x > 0 ? 0.2f : 0.02f);
  ReconstructionOptions options;
  options.maxSupport = 0.5;
  const auto meanSupports = [&] {
    double sum[2]{}, count[2]{};
    const CsrbfModel model = fitCsrbf(points, options);
    for (const Centre& c : model.centres())
      sum[c.position.x > 0] += double(c.support), count[c.position.x > 0] += 1;
    return std::array{sum[0] / count[0], sum[1] / count[1]};
  };
  const auto [quiet, noisy] = meanSupports();
  EXPECT_GT(noisy, 1.3 * quiet);
  options.measuredNoise = false;
  const auto [one, other] = meanSupports();
  EXPECT_NEAR(one, other, 0.1 * one);
}

// `smoothness` scales what the noise asks for.
TEST(MeasuredNoise, IsScaledBySmoothness) {
  SupportRule rule{1, 10, 100, 2e-5};
  const double usual = rule.atNoise(0.2).smoothness;
  rule.smoothness = 4e-5;
  EXPECT_NEAR(rule.atNoise(0.2).smoothness, 2 * usual, 1e-12);
  EXPECT_NEAR(rule.atNoise(0.4).smoothness, 4 * usual, 1e-12);
}

}  // namespace
}  // namespace sonoskin
