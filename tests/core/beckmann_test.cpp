#include "core/skin/beckmann.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "core/skin/skin_material.h"

namespace sonoskin {
namespace {

constexpr std::array<double, 5> kRoughness{0.1, 0.2, 0.3, 0.4, 0.5};

TEST(Beckmann, DensityCoversTheSurfaceOnce) {
  for (double m : kRoughness) {
    const int steps = 20000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      const double theta = std::numbers::pi / 2 * (i + 0.5) / steps;
      sum += beckmannDensity(std::cos(theta), m) * std::cos(theta) * std::sin(theta);
    }
    EXPECT_NEAR(sum * 2 * std::numbers::pi * (std::numbers::pi / 2) / steps, 1, 1e-6);
  }
}

TEST(Beckmann, SchlickIsCloseToFresnel) {
  EXPECT_NEAR(schlickFresnel(0.5), 0.0584, 5e-5);
  EXPECT_NEAR(schlickFresnel(0.1), 0.602, 5e-4);
  EXPECT_EQ(schlickFresnel(1), kNormalReflectance);
}

TEST(Beckmann, DirectionalAlbedo) {
  struct Row {
    double cosine;
    std::array<double, 5> value;
  };
  const std::array<Row, 11> rows{{{1, {0.0277, 0.0269, 0.0255, 0.0235, 0.0212}},
                                  {0.9, {0.0277, 0.0268, 0.0254, 0.0234, 0.0211}},
                                  {0.8, {0.0281, 0.0275, 0.0262, 0.0241, 0.0218}},
                                  {0.7, {0.0306, 0.0305, 0.0289, 0.0264, 0.0239}},
                                  {0.6, {0.0388, 0.0385, 0.0352, 0.0313, 0.0280}},
                                  {0.5, {0.0592, 0.0549, 0.0471, 0.0405, 0.0354}},
                                  {0.4, {0.1007, 0.0834, 0.0672, 0.0561, 0.0482}},
                                  {0.3, {0.1715, 0.1279, 0.0997, 0.0819, 0.0698}},
                                  {0.2, {0.2724, 0.1944, 0.1519, 0.1253, 0.1070}},
                                  {0.1, {0.3994, 0.3002, 0.2428, 0.2042, 0.1765}},
                                  {0.05, {0.4900, 0.3904, 0.3227, 0.2745, 0.2391}}}};
  for (const Row& row : rows)
    for (size_t m = 0; m < 5; ++m)
      EXPECT_NEAR(directionalAlbedo(row.cosine, kRoughness[m]), row.value[m], 1e-4)
          << row.cosine << " " << kRoughness[m];
  const std::array<double, 5> means{0.0653, 0.0553, 0.0473, 0.0410, 0.0360};
  for (size_t m = 0; m < 5; ++m) EXPECT_NEAR(meanAlbedo(kRoughness[m]), means[m], 1e-4);
}

// A sum over light directions, without the change to facets.
TEST(Beckmann, AlbedoIsTheIntegralOverLightDirections) {
  for (double cosine : {0.9, 0.35}) {
    const double m = 0.4;
    const glm::dvec3 view(std::sqrt(1 - cosine * cosine), 0, cosine);
    const int polar = 400, around = 800;
    double sum = 0;
    for (int i = 0; i < polar; ++i)
      for (int j = 0; j < around; ++j) {
        const double c = (i + 0.5) / polar, s = std::sqrt(1 - c * c),
                     phi = 2 * std::numbers::pi * (j + 0.5) / around;
        const glm::dvec3 both = glm::dvec3(s * std::cos(phi), s * std::sin(phi), c) + view,
                         h = glm::normalize(both);
        sum += beckmannDensity(h.z, m) * schlickFresnel(glm::dot(view, h)) / glm::dot(both, both) * c;
      }
    EXPECT_NEAR(directionalAlbedo(cosine, m), sum * 2 * std::numbers::pi / (polar * around), 1e-5);
  }
}

TEST(Beckmann, WhiteGlossSendsBackNoMoreThanItGets) {
  EXPECT_NEAR(directionalAlbedo(1, 0.3, 1), 0.910, 1e-3);
  EXPECT_NEAR(directionalAlbedo(0.3, 0.3, 1), 0.781, 1e-3);
  EXPECT_NEAR(directionalAlbedo(0.05, 0.3, 1), 0.852, 1e-3);
  for (double m : {0.05, 0.1, 0.3, 0.65})
    for (int i = 0; i <= 50; ++i) EXPECT_LE(directionalAlbedo(i / 50.0, m, 1), 1.0) << i << " " << m;
}

TEST(Beckmann, TableIsTheAlbedo) {
  const SpecularTable& table = specularTable();
  ASSERT_EQ(table.value.size(), size_t(SpecularTable::kCosines * SpecularTable::kRoughnesses));
  ASSERT_EQ(table.mean.size(), size_t(SpecularTable::kRoughnesses));
  const int row = 21;
  const double m = 0.05 + 0.6 * row / 31;
  EXPECT_NEAR(table.value[size_t(row * SpecularTable::kCosines + 21)], directionalAlbedo(21 / 63.0, m), 1e-7);
  EXPECT_NEAR(table.mean[size_t(row)], meanAlbedo(m), 1e-7);
}

}  // namespace
}  // namespace sonoskin
