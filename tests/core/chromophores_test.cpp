#include "core/skin/chromophores.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin {
namespace {

struct Look {
  const char* name;
  Pigments pigments;
  glm::dvec3 linear;
  int code;  // sRGB
};
const std::array<Look, 8> kLooks{{
    {"newborn", {0.005, 0.010, 0.80, 0.06}, {0.477, 0.300, 0.221}, 0xb89581},
    {"first hours", {0.005, 0.025, 0.70, 0.06}, {0.404, 0.207, 0.150}, 0xaa7e6c},
    {"preterm", {0.002, 0.035, 0.70, 0.03}, {0.387, 0.184, 0.140}, 0xa77768},
    {"darker", {0.03, 0.012, 0.78, 0.06}, {0.405, 0.218, 0.127}, 0xab8164},
    {"cheek", {0.005, 0.03, 0.85, 0.06}, {0.418, 0.190, 0.139}, 0xad7968},
    {"lip", {0.002, 0.07, 0.75, 0.03}, {0.334, 0.120, 0.093}, 0x9c6156},
    {"lid", {0.005, 0.02, 0.45, 0.04}, {0.393, 0.233, 0.173}, 0xa88574},
    {"vernix", {0.002, 0.002, 0.80, 0.03}, {0.549, 0.458, 0.363}, 0xc4b4a2},
}};

int encoded(double linear) {
  const double s = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return int(std::lround(255 * s));
}

TEST(Chromophores, ColoursOfTheLooks) {
  for (const Look& look : kLooks) {
    const glm::dvec3 albedo = skinAlbedo(look.pigments);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(albedo[c], look.linear[c], 6e-4) << look.name << " " << c;
      EXPECT_NEAR(encoded(albedo[c]), (look.code >> (16 - 8 * c)) & 255, 1) << look.name << " " << c;
    }
  }
}

TEST(Chromophores, EqualEnergyIsWhite) {
  Spectrum white;
  white.fill(1);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(linearColour(white)[c], 1, 1e-12);
}

// Red light gains and blue light loses against green in every pigment, as blood and melanin have it.
TEST(Chromophores, MorePigmentIsDarker) {
  const auto albedo = [](double melanin, double blood) { return skinAlbedo({melanin, blood, 0.8, 0.06}); };
  for (int c = 0; c < 3; ++c) {
    EXPECT_GT(albedo(0.01, 0.01)[c], albedo(0.05, 0.01)[c]);
    EXPECT_GT(albedo(0.01, 0.01)[c], albedo(0.01, 0.05)[c]);
  }
  EXPECT_LT(albedo(0.01, 0.05).y / albedo(0.01, 0.05).x, albedo(0.01, 0.01).y / albedo(0.01, 0.01).x);
}

TEST(Chromophores, BloodAtTwoWavelengths) {
  // 2.303 * epsilon * 170 / 64500 / 10
  EXPECT_NEAR(bloodAbsorption(1)[23], 2.302585 * 610 * 170 / 64500 / 10, 1e-6);
  EXPECT_NEAR(bloodAbsorption(0)[15], 2.302585 * 53412 * 170 / 64500 / 10, 1e-4);
  EXPECT_NEAR(bloodAbsorption(0.25)[6], 2.302585 * (0.25 * 44480 + 0.75 * 23388.8) * 170 / 64500 / 10, 1e-4);
}

// 2 E_3(x) = 2 int_1^inf exp(-x t) / t^3 dt = 2 int_0^1 exp(-x / c) c dc: diffuse light at all angles.
TEST(Chromophores, EpidermisPassesLightOfAllAngles) {
  const Spectrum absorption = epidermisAbsorption(0.05);
  const Spectrum passed = epidermisTransmittance(0.05, 0.1), through = epidermisTransmittance(0.05, 0);
  for (size_t i = 0; i < kWavelengths; i += 10) {
    const int steps = 2000;
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
      const double c = (k + 0.5) / steps;
      sum += 2 * std::exp(-absorption[i] * 0.1 / c) * c / steps;
    }
    EXPECT_NEAR(passed[i], sum, 1e-6);
    EXPECT_EQ(through[i], 1);
  }
}

TEST(Chromophores, NewbornDermisSpreadsLightAsFar) {
  const MediumRgb medium = dermisRgb({0.005, 0.010, 0.80, 0.06});
  const std::array<double, 3> path{1.56, 0.56, 0.45}, total{0.520, 0.292, 0.326};
  for (size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(1 / makeDipole(medium[c]).decay, path[c], 6e-3);
    EXPECT_NEAR(totalReflectance(makeDipole(medium[c])), total[c], 6e-4);
  }
}

}  // namespace
}  // namespace sonoskin
