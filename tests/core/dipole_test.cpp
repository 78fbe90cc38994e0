#include "core/skin/dipole.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace sonoskin {
namespace {

using Values = std::array<double, 3>;

MediumRgb secondSkin() {
  return {ScatteringMedium{0.013, 1.09}, ScatteringMedium{0.070, 1.59}, ScatteringMedium{0.145, 1.79}};
}

template <class F>
void expectChannels(const MediumRgb& medium, const Values& expected, double tolerance, const F& value) {
  for (size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(value(makeDipole(medium[c])), expected[c], tolerance) << "channel " << c;
}

TEST(Dipole, ParametersOfSkin) {
  const MediumRgb skin = jensenSkin();
  EXPECT_NEAR(internalReflection(1.3), 2.602064, 1e-6);
  EXPECT_NEAR(internalReflection(1.4), 3.250697, 1e-6);
  expectChannels(skin, {0.958549, 0.838095, 0.677852}, 1e-6, [](const Dipole& d) { return d.albedo; });
  expectChannels(skin, {0.272235, 0.731779, 1.464787}, 1e-6, [](const Dipole& d) { return d.decay; });
  expectChannels(skin, {1.295337, 0.952381, 0.671141}, 1e-6, [](const Dipole& d) { return d.real; });
  expectChannels(skin, {5.789403, 4.256590, 2.999610}, 1e-6, [](const Dipole& d) { return d.virtualSource; });
}

TEST(Dipole, TotalReflectance) {
  expectChannels(jensenSkin(), {0.435956, 0.227331, 0.130999}, 1e-6, totalReflectance);
  expectChannels(secondSkin(), {0.622631, 0.433271, 0.343458}, 1e-6, totalReflectance);
  MediumRgb denser = jensenSkin();
  for (ScatteringMedium& m : denser) m.eta = 1.4;
  expectChannels(denser, {0.409905, 0.218912, 0.128601}, 1e-6, totalReflectance);
  // as published, to two digits [Jensen et al. 2001]
  expectChannels(jensenSkin(), {0.44, 0.22, 0.13}, 0.008, totalReflectance);
  expectChannels(secondSkin(), {0.63, 0.44, 0.34}, 0.008, totalReflectance);
}

TEST(Dipole, ProfileOfSkin) {
  struct Row {
    double r;
    Values value;
  };
  const std::vector<Row> rows{{0, {0.044431, 0.062824, 0.089257}},   {0.1, {0.044035, 0.061713, 0.085913}},
                              {0.5, {0.036048, 0.042161, 0.040710}}, {1, {0.022019, 0.018234, 0.010096}},
                              {2, {0.007261, 0.003416, 0.000828}},   {4, {0.001452, 0.000285, 0.000017}},
                              {8, {0.000181, 0.000006, 0}}};
  for (const Row& row : rows)
    expectChannels(jensenSkin(), row.value, 1e-6,
                   [&](const Dipole& d) { return diffuseReflectance(d, row.r); });
}

// The closed integral over a disc and a sum over its rings.
TEST(Dipole, EnergyWithinADiscIsTheIntegralOfTheProfile) {
  for (const ScatteringMedium& medium : jensenSkin()) {
    const Dipole d = makeDipole(medium);
    const double step = 1e-3;
    double sum = 0;
    for (int i = 0; i < 3000; ++i) {
      const double r = step * (i + 0.5);
      sum += diffuseReflectance(d, r) * 2 * std::numbers::pi * r * step;
    }
    EXPECT_NEAR(reflectanceWithin(d, 3), sum, 1e-7);
    EXPECT_NEAR(reflectanceWithin(d, 0), 0, 1e-15);
    EXPECT_NEAR(reflectanceWithin(d, 500), totalReflectance(d), 1e-12);
  }
}

TEST(Dipole, RadiiOfSkin) {
  const std::array<double, 3> shares{0.5, 0.9, 0.99};
  const std::array<Values, 3> radii{{{2.041, 1.074, 0.651}, {6.611, 2.861, 1.567}, {13.67, 5.76, 2.99}}};
  for (size_t s = 0; s < 3; ++s)
    for (size_t c = 0; c < 3; ++c) {
      const Dipole d = makeDipole(jensenSkin()[c]);
      const double tolerance = s == 2 ? 6e-3 : 6e-4;
      EXPECT_LT(reflectanceWithin(d, radii[s][c] - tolerance), shares[s] * totalReflectance(d));
      EXPECT_GT(reflectanceWithin(d, radii[s][c] + tolerance), shares[s] * totalReflectance(d));
    }
}

TEST(Dipole, MeanRadiusOfSkin) {
  const Values means{2.979, 1.404, 0.805};
  for (size_t c = 0; c < 3; ++c) {
    const Dipole d = makeDipole(jensenSkin()[c]);
    const double step = 5e-3;
    double sum = 0;  // of what lies beyond each radius
    for (int i = 0; i < 20000; ++i)
      sum += (totalReflectance(d) - reflectanceWithin(d, step * (i + 0.5))) * step;
    EXPECT_NEAR(sum / totalReflectance(d), means[c], 6e-4);
  }
}

TEST(Dipole, HalfPlane) {
  struct Row {
    double x;
    Values value;
  };
  const std::vector<Row> rows{{-2, {0.0680, 0.0115, 0.0012}},
                              {-1, {0.1193, 0.0353, 0.0085}},
                              {0, {0.2180, 0.1137, 0.0655}},
                              {1, {0.3166, 0.1920, 0.1225}},
                              {2, {0.3680, 0.2158, 0.1298}}};
  for (const Row& row : rows)
    expectChannels(jensenSkin(), row.value, 6e-5,
                   [&](const Dipole& d) { return reflectanceOfHalfPlane(d, row.x); });
}

TEST(Dipole, SpectrumIsTheTransformOfTheProfile) {
  const Dipole d = makeDipole(jensenSkin()[1]);
  for (double s : {0.3, 1.0, 3.0}) {
    const double step = 2e-3;
    double sum = 0;
    for (int i = 0; i < 20000; ++i) {
      const double r = step * (i + 0.5);
      sum += diffuseReflectance(d, r) * std::cyl_bessel_j(0, s * r) * 2 * std::numbers::pi * r * step;
    }
    EXPECT_NEAR(reflectanceSpectrum(d, s), sum, 1e-6);
  }
}

}  // namespace
}  // namespace sonoskin
