#include "render/skin/blur_kernel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin {
namespace {

double moment(const BlurKernel& k, int power) {
  double sum = power == 0 ? double(k.weights[0]) : 0;
  for (std::size_t i = 1; i < k.weights.size(); ++i)
    sum += 2 * double(k.weights[i]) * std::pow(double(k.places[i]), power);
  return sum;
}

// What is left of a sinusoid of `period` standard deviations.
double response(const BlurKernel& k, double period) {
  double sum = double(k.weights[0]);
  for (std::size_t i = 1; i < k.weights.size(); ++i)
    sum += 2 * double(k.weights[i]) * std::cos(2 * M_PI * double(k.places[i]) / period);
  return sum;
}

TEST(BlurKernel, HasSumAndVarianceOne) {
  for (const double spacing : {1.0, 0.5, 0.25}) {
    const BlurKernel k = makeBlurKernel(spacing);
    EXPECT_EQ(k.weights.size(), std::size_t(3.5 / spacing) + 1);
    EXPECT_NEAR(moment(k, 0), 1, 1e-6);
    EXPECT_NEAR(moment(k, 2), 1, 1e-5);
  }
}

// The taps of a kernel whose sum and variance are one.                               [theory/skin.md, 5.2]
TEST(BlurKernel, SevenTapsAreThoseOfTheSpecification) {
  const BlurKernel k = makeBlurKernel(1);
  const double printed[] = {0.398215, 0.242037, 0.054347, 0.004508};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(double(k.weights[i]), printed[i], 4e-6);
    EXPECT_NEAR(double(k.places[i]), double(i), 1e-9);
  }
}

// As far as a Gaussian can that ends at 3.5 standard deviations.
TEST(BlurKernel, DampsWavesAsAGaussianDoes) {
  for (const double spacing : {1.0, 0.5, 0.25})
    for (const double period : {3.0, 4.0, 6.0, 10.0, 20.0})
      EXPECT_NEAR(response(makeBlurKernel(spacing), period), std::exp(-2 * M_PI * M_PI / (period * period)),
                  0.003)
          << spacing << " " << period;
}

TEST(BlurSpacing, FollowsTexelsAndEarlierBlurs) {
  EXPECT_EQ(blurSpacing(0.22, 0.15, 0), 1);        // the face: 1.5 texels
  EXPECT_EQ(blurSpacing(0.22, 0.05, 0), 1.0 / 3);  // sharp shadows on fine texels
  EXPECT_EQ(blurSpacing(0.37, 0.05, 0.22), 1);     // blurred before
  EXPECT_EQ(blurSpacing(9, 0.05, 0), 1.0 / 6);     // no more taps than the shader holds
}

}  // namespace
}  // namespace sonoskin
