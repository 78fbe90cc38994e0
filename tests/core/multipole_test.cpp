#include "core/skin/multipole.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sonoskin {
namespace {

// The sums over images as they are published.
Plate summed(const ScatteringMedium& medium, double thickness, double s, int pairs) {
  const Dipole dipole = makeDipole(medium);
  const double q = std::hypot(s, dipole.decay), beyond = dipole.virtualSource - dipole.real;
  const auto term = [q](double z) { return std::copysign(std::exp(-std::abs(z) * q), z); };
  Plate plate;
  for (int i = -pairs; i <= pairs; ++i) {
    const double real = 2 * i * (thickness + beyond) + dipole.real;
    const double virtualSource = 2 * i * (thickness + beyond) - dipole.real - beyond;
    plate.reflectance += dipole.albedo / 2 * (term(real) - term(virtualSource));
    plate.transmittance += dipole.albedo / 2 * (term(thickness - real) - term(thickness - virtualSource));
  }
  return plate;
}

TEST(Multipole, TransmittanceOfSkin) {
  struct Row {
    double thickness;
    std::array<double, 3> value;
  };
  const std::vector<Row> rows{{2, {0.451, 0.207, 0.0498}}, {3, {0.339, 0.0998, 0.0115}},
                              {4, {0.256, 0.048, 0.0027}}, {6, {0.148, 0.0111, 0.0001}},
                              {10, {0.0496, 0.0006, 0}},   {15, {0.0127, 0, 0}},
                              {20, {0.0033, 0, 0}}};
  for (const Row& row : rows)
    for (size_t c = 0; c < 3; ++c) {
      if (row.thickness > 10 && c > 0) continue;
      const double tolerance = row.value[c] > 0.1 ? 6e-4 : 6e-5;
      EXPECT_NEAR(plateOf(jensenSkin()[c], row.thickness).transmittance, row.value[c], tolerance)
          << row.thickness << " mm, channel " << c;
    }
}

TEST(Multipole, ClosedFormIsTheSumOfTheImages) {
  for (const ScatteringMedium& medium : jensenSkin())
    for (double thickness : {1.4, 3.0, 12.0})
      for (double s : {0.0, 0.4, 2.0}) {
        const Plate closed = plateOf(medium, thickness, s), sum = summed(medium, thickness, s, 60);
        EXPECT_NEAR(closed.reflectance, sum.reflectance, 1e-12);
        EXPECT_NEAR(closed.transmittance, sum.transmittance, 1e-12);
      }
}

TEST(Multipole, NothingIsLostWithoutAbsorption) {
  for (double thickness : {1.5, 5.0, 100.0})
    for (double absorption : {0.0, 1e-14}) {
      const Plate plate = plateOf({absorption, 1.0, 1.3}, thickness);
      EXPECT_NEAR(plate.reflectance + plate.transmittance, 1, 1e-7);
      EXPECT_GT(plate.transmittance, 0);
    }
}

TEST(Multipole, AThickPlateIsTheDipole) {
  for (const ScatteringMedium& medium : jensenSkin()) {
    const Plate plate = plateOf(medium, 1000);
    EXPECT_NEAR(plate.reflectance, totalReflectance(makeDipole(medium)), 1e-12);
    EXPECT_NEAR(plate.transmittance, 0, 1e-12);
  }
}

// Two plates: what light does between them, bounce by bounce.
TEST(Multipole, LayersAreTheSumOfAllBounces) {
  const Plate upper{0.3, 0.5}, lower{0.6, 0.2};
  Plate bounced{upper.reflectance, 0};
  double between = upper.transmittance;
  for (int bounce = 0; bounce < 60; ++bounce) {
    bounced.transmittance += between * lower.transmittance;
    between *= lower.reflectance;
    bounced.reflectance += between * upper.transmittance;
    between *= upper.reflectance;
  }
  const Plate both = onTop(upper, lower);
  EXPECT_NEAR(both.reflectance, bounced.reflectance, 1e-14);
  EXPECT_NEAR(both.transmittance, bounced.transmittance, 1e-14);
  EXPECT_NEAR(onTop({0.4, 0.6}, {0.3, 0.7}).reflectance + onTop({0.4, 0.6}, {0.3, 0.7}).transmittance, 1,
              1e-15);
}

}  // namespace
}  // namespace sonoskin
