#include "core/rbf/basis.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

TEST(Basis, HasTheKnownValues) {
  EXPECT_FLOAT_EQ(wendland(0), 1);
  EXPECT_FLOAT_EQ(wendland(0.25f), 0.6328125f);
  EXPECT_FLOAT_EQ(wendland(0.5f), 0.1875f);
  EXPECT_FLOAT_EQ(wendland(0.75f), 0.015625f);
  EXPECT_FLOAT_EQ(wendland(1), 0);
  EXPECT_FLOAT_EQ(wendland(7), 0);
}

// φ'(t) = f(t) t: with σ = 1 and x - c of length t.
TEST(Basis, HasTheKnownDerivative) {
  const auto derivative = [](float t) { return wendlandGradientFactor(t) * t; };
  EXPECT_FLOAT_EQ(derivative(0), 0);
  EXPECT_FLOAT_EQ(derivative(0.5f), -1.25f);
  EXPECT_FLOAT_EQ(derivative(1), 0);
  for (float t = 0.1f; t < 1.2f; t += 0.1f)
    EXPECT_NEAR(derivative(t), (wendland(t + 1e-3f) - wendland(t - 1e-3f)) / 2e-3f, 1e-3f);
}

TEST(Basis, HasTheKnownMeans) {
  const int steps = 100000;
  double segment = 0, disc = 0, ball = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps, phi = double(wendland(float(t))) / steps;
    segment += phi;
    disc += 2 * t * phi;
    ball += 3 * t * t * phi;
  }
  EXPECT_NEAR(segment, 1.0 / 3, 1e-5);
  EXPECT_NEAR(disc, 1.0 / 7, 1e-5);
  EXPECT_NEAR(ball, 1.0 / 14, 1e-5);
}

}  // namespace
}  // namespace sonoskin
