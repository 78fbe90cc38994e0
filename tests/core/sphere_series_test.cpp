#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/skin/gaussian_sum.h"
#include "tests/support/skin_tables.h"

// A ball under far light is the one curved surface where the spread has a closed form: a series of Legendre
// polynomials. The tables that the surface integrals are held against come from here.
namespace sonoskin {
namespace {

constexpr size_t kTerms = 3000;

// max(0, cos) = sum a_l P_l(cos).
std::vector<double> clampedCosine() {
  std::vector<double> a(kTerms, 0.0);
  double integral = 0.5;  // of t P_l(t) over 0 .. 1
  for (size_t l = 0; l < kTerms; l += 2) {
    a[l] = (2.0 * double(l) + 1) / 2 * integral;
    integral *= -(double(l) - 1) / (double(l) + 4);
  }
  a[1] = 0.5;
  return a;
}

// What a Gaussian of the chord's length leaves of each term: (1 - exp(-2k)) I_{l+1/2}(k) / I_{1/2}(k), with
// k = a^2 / v; the ratios of neighbours by their recurrence from the far end, which is the stable way.
std::vector<double> chordFactors(double radius, double v) {
  const double k = radius * radius / v;
  const size_t end = kTerms + 200 + size_t(8 * std::sqrt(k));
  std::vector<double> factor(kTerms, 1.0);
  double ratio = 0;
  for (size_t l = end; l > 0; --l) {
    ratio = 1 / ((2.0 * double(l) + 1) / k + ratio);
    if (l < kTerms) factor[l] = ratio;
  }
  factor[0] = -std::expm1(-2 * k);
  for (size_t l = 1; l < kTerms; ++l) factor[l] *= factor[l - 1];
  return factor;
}

// What heat that flows along the surface leaves of each term.
std::vector<double> heatFactors(double radius, double v) {
  std::vector<double> factor;
  for (size_t l = 0; l < kTerms; ++l)
    factor.push_back(std::exp(-double(l) * double(l + 1) * v / (2 * radius * radius)));
  return factor;
}

using Factors = std::function<std::vector<double>(double radius, double v)>;

// SphereSeries: light at an angle, in degrees, from that of the lamp.
class SphereSeries {
 public:
  SphereSeries(double radius, const Factors& factors) : coefficient_(kTerms, glm::dvec3(0)) {
    const GaussianSum skin = literatureSkin();
    const std::vector<double> a = clampedCosine();
    for (size_t i = 0; i < skin.variances.size(); ++i) {
      const std::vector<double> left = factors(radius, skin.variances[i]);
      for (size_t l = 0; l < kTerms; ++l) coefficient_[l] += skin.weights[i] * a[l] * left[l];
    }
  }
  glm::dvec3 operator()(double degrees) const {
    const double x = std::cos(degrees * std::numbers::pi / 180);
    glm::dvec3 sum(0);
    double p = 1, before = 0;
    for (size_t l = 0; l < kTerms; ++l) {
      sum += coefficient_[l] * p;
      const double next = ((2.0 * double(l) + 1) * x * p - double(l) * before) / (double(l) + 1);
      before = p, p = next;
    }
    return sum;
  }

 private:
  std::vector<glm::dvec3> coefficient_;
};

template <class Table>
void expectTable(const SphereSeries& series, const Table& table) {
  for (const test::SkinValue& row : table)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(series(row.at)[c], row.light[c], 1e-6) << row.at << " degrees, channel " << c;
}

TEST(SphereSeries, TenMillimetres) { expectTable(SphereSeries(10, chordFactors), test::kSphere10); }

TEST(SphereSeries, TwentyMillimetres) {
  const SphereSeries series(20, chordFactors);
  expectTable(series, test::kSphere20);
  expectTable(series, std::vector<test::SkinValue>{{60, {0.498272, 0.499915, 0.499969}},
                                                   {85, {0.089871, 0.087157, 0.087151}},
                                                   {92, {0.008505, 0.000178, 0.000026}},
                                                   {100, {0.000570, 0.000001, 0}}});
}

TEST(SphereSeries, FortyMillimetres) {
  expectTable(SphereSeries(40, chordFactors),
              std::vector<test::SkinValue>{{0, {0.999136, 0.999957, 0.999985}},
                                           {60, {0.499568, 0.499979, 0.499992}},
                                           {80, {0.173507, 0.173641, 0.173645}},
                                           {85, {0.087360, 0.087152, 0.087154}},
                                           {88, {0.036999, 0.034912, 0.034901}},
                                           {90, {0.008911, 0.002063, 0.001325}},
                                           {92, {0.002130, 0.000014, 0.000002}},
                                           {95, {0.000280, 0, 0}},
                                           {100, {0.000009, 0, 0}}});
}

// Spreading along the surface stands for the integral over straight distances: on a face they are the same.
TEST(SphereSeries, HeatAlongTheSurfaceIsAsGood) {
  const auto largest = [](double radius) {
    const SphereSeries chord(radius, chordFactors), heat(radius, heatFactors);
    double most = 0;
    for (int degrees = 0; degrees <= 180; degrees += 5)
      most = std::max(most, std::abs(chord(degrees).x - heat(degrees).x));
    return most;
  };
  EXPECT_LT(largest(10), 3e-4);
  EXPECT_LT(largest(20), 3e-5);
}

TEST(SphereSeries, RedBleedsPastTheTerminator) {
  const double radius = 10;
  const GaussianSum skin = literatureSkin();
  const glm::dvec3 light = SphereSeries(radius, chordFactors)(90);
  EXPECT_NEAR(light.x / light.y, 4.3, 0.05);
  double shortcut = 0;  // sum w sigma / (a sqrt(2 pi))
  for (size_t i = 0; i < 6; ++i)
    shortcut += skin.weights[i].x * std::sqrt(skin.variances[i]) / (radius * std::sqrt(2 * std::numbers::pi));
  EXPECT_NEAR(light.x / shortcut, 1, 0.02);
}

}  // namespace
}  // namespace sonoskin
