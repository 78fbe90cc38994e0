#include "core/rbf/surface/support_margin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

constexpr float kGap = 2, kLimit = 1, kDensity = 0.5f;
constexpr float kBand = SupportMargin::kBand;
constexpr SupportLimits kLimits{1, kGap, kLimit, kDensity};

float densityAt(const SurfacePoints& points, const glm::vec3& place, const glm::vec3& normal) {
  float sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float rest = 1 - glm::dot(points.positions[i] - place, points.positions[i] - place) / 25;
    if (rest > 0 && glm::dot(points.normals[i], normal) > 0.3f) sum += rest * rest;
  }
  return sum;
}

float usualDensity(const SurfacePoints& points) {
  std::vector<float> all;
  for (std::size_t i = 0; i < points.size(); ++i)
    all.push_back(densityAt(points, points.positions[i], points.normals[i]));
  std::sort(all.begin(), all.end());
  return all[all.size() / 2];
}

SupportMargin::Place marginAt(const SupportMargin& support, const glm::vec3& place, const glm::vec3& normal,
                              float coverage) {
  SupportMargin::Nearby nearby;
  support.gather(place + glm::vec3(0.3f, 0.4f, 0), 0.6f, nearby);
  return support.at(place, normal, coverage, nearby);
}

TEST(SupportMargin, IsTheBruteForceOne) {
  const SurfacePoints points = planePoints(20);
  const SupportMargin support(points, kLimits);
  const float usual = usualDensity(points);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> along(-5, 25), up(-4, 4), covered(0.5, 3);
  int inside = 0, outside = 0, beyond = 0, ruledOut = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::vec3 place(along(random), along(random), up(random)), normal(0, 0, i % 5 == 0 ? -1 : 1);
    const float coverage = covered(random);
    float least = 1e9f;
    for (const glm::vec3& p : points.positions) least = std::min(least, glm::distance(p, place));
    const float near = (kGap - least) / kGap, over = (coverage - kLimit) / kLimit;
    const float dense = (densityAt(points, place, normal) / usual - kDensity) / 0.6f;
    const float expected = std::clamp(std::min({near, over, dense}), -kBand, kBand);
    const SupportMargin::Place margin = marginAt(support, place, normal, coverage);
    ASSERT_NEAR(margin.value, expected, 1e-4f);
    ASSERT_EQ(margin.isBeyond, near <= 0 || over <= 0);
    (expected > 0 ? inside : outside) += 1;
    beyond += margin.isBeyond;
    if (!support.mayStay(place, 0.5f)) {
      ASSERT_EQ(expected, -kBand);
      ++ruledOut;
    }
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 300);
  EXPECT_GT(beyond, 300);
  EXPECT_GT(ruledOut, 100);
}

TEST(SupportMargin, AStraightBorderOfPointsIsWhereTheDensityIsHalf) {
  SurfacePoints half;
  const SurfacePoints plane = planePoints(40);
  for (std::size_t i = 0; i < plane.size(); ++i) {
    if (plane.positions[i].x >= 20) continue;
    half.positions.push_back(plane.positions[i]);
    half.normals.push_back(plane.normals[i]);
    half.confidence.push_back(1);
  }
  const SupportMargin support(half, {1, 4, 0, 0.5f});
  const auto at = [&](float x) { return marginAt(support, {x, 20, 0}, {0, 0, 1}, 1).value; };
  EXPECT_NEAR(at(20), 0, 0.05f);
  EXPECT_EQ(at(15), kBand);
  EXPECT_LT(at(22), -0.2f);
}

TEST(SupportMargin, WithoutLimitsOnlyTheDistanceCounts) {
  const SurfacePoints points = planePoints(5);
  const SupportMargin support(points, {1, kGap, 0, 0});
  EXPECT_EQ(marginAt(support, points.positions[3], {0, 0, 1}, 0).value, kBand);
  EXPECT_TRUE(marginAt(support, {0, 0, 2.5f}, {0, 0, 1}, 0).isBeyond);
}

}  // namespace
}  // namespace sonoskin
