#include "core/rbf/support_margin.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/synthetic_points.h"

namespace sonoskin {
namespace {

constexpr float kGap = 2, kLimit = 1;

// The least distance, by trying every point.
float expectedMargin(const std::vector<glm::vec3>& points, const glm::vec3& place, float coverage) {
  float least = 1e9f;
  for (const glm::vec3& p : points) least = std::min(least, glm::distance(p, place));
  const float band = SupportMargin::kBand;
  // What is nearer than half the gap counts as safe.
  const float byDistance = least < (1 - band) * kGap ? band : (kGap - least) / kGap;
  return std::clamp(std::min(byDistance, (coverage - kLimit) / kLimit), -band, band);
}

TEST(SupportMargin, IsTheBruteForceOne) {
  const std::vector<glm::vec3> points = planePoints(12).positions;
  const SupportMargin support(points, 1, kGap, kLimit);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> along(-5, 17), up(-4, 4), covered(0, 3);
  SupportMargin::Hint hint;
  int inside = 0, outside = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::vec3 place(along(random), along(random), up(random));
    const float coverage = covered(random), expected = expectedMargin(points, place, coverage);
    ASSERT_NEAR(support.at(place, coverage, hint), expected, 1e-5f);
    (expected > 0 ? inside : outside) += 1;
    if (!support.mayStay(place, 0.5f)) {
      ASSERT_EQ(expected, -SupportMargin::kBand);
    }
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 300);
}

TEST(SupportMargin, WithoutALimitOnlyTheDistanceCounts) {
  const std::vector<glm::vec3> points = planePoints(5).positions;
  SupportMargin::Hint hint;
  EXPECT_EQ(SupportMargin(points, 1, kGap, 0).at(points[3], 0, hint), SupportMargin::kBand);
}

}  // namespace
}  // namespace sonoskin
