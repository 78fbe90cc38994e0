#include "core/phantom/random_field.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin {
namespace {

constexpr std::uint32_t kCount = 1u << 20;

TEST(RandomField, NormalsHaveMeanZeroVarianceOneAndNoMemory) {
  const std::uint32_t key = streamKey(1, 5), other = streamKey(1, 6), reseeded = streamKey(2, 5);
  double sum = 0, squares = 0, neighbours = 0, streams = 0, seeds = 0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const double v = normalAt(i, key);
    sum += v;
    squares += v * v;
    neighbours += v * normalAt(i + 1, key);
    streams += v * normalAt(i, other);
    seeds += v * normalAt(i, reseeded);
  }
  EXPECT_NEAR(sum / kCount, 0, 0.004);
  EXPECT_NEAR(squares / kCount, 1, 0.006);
  for (double product : {neighbours, streams, seeds}) EXPECT_NEAR(product / kCount, 0, 0.004);
}

TEST(RandomField, UniformsFillTheirInterval) {
  double sum = 0, squares = 0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const double v = uniformAt(i, 42);
    ASSERT_GE(v, 0);
    ASSERT_LT(v, 1);
    sum += v;
    squares += v * v;
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.002);
  EXPECT_NEAR(squares / kCount, 1. / 3, 0.002);
}

TEST(RandomField, ValueNoiseIsSmoothAndWithinBounds) {
  for (float x = -30; x < 30; x += 0.1f) {
    const glm::vec3 p(x, 0.3f * x, 5 - x);
    const float v = valueNoise(p, 4, 9);
    ASSERT_GE(v, 0);
    ASSERT_LE(v, 1);
    ASSERT_LT(std::abs(valueNoise(p + glm::vec3(0.01f, 0, 0), 4, 9) - v), 0.005f);
  }
}

}  // namespace
}  // namespace sonoskin
