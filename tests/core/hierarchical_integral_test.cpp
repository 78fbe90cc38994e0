#include "core/skin/hierarchical_integral.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/skin/dipole.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"
#include "tests/support/skin_tables.h"

namespace sonoskin {
namespace {

using Dipoles = std::array<Dipole, 3>;

Dipoles jensenDipoles() {
  const MediumRgb medium = jensenSkin();
  return {makeDipole(medium[0]), makeDipole(medium[1]), makeDipole(medium[2])};
}

glm::dvec3 reflectance(const Dipoles& d, double r) {
  return {diffuseReflectance(d[0], r), diffuseReflectance(d[1], r), diffuseReflectance(d[2], r)};
}

RadialProfile dipoleProfile() {
  const Dipoles d = jensenDipoles();
  return RadialProfile([d](double r) { return reflectance(d, r); },
                       {totalReflectance(d[0]), totalReflectance(d[1]), totalReflectance(d[2])});
}

double terminator(const glm::vec3&, const glm::vec3& n) { return std::max(0.f, n.z); }

// Samples as far apart as those of the errors in theory/skin.md, 6.2: 95,000 on about 14,000 mm^2.
struct Head {
  SurfaceSamples samples = sampleSurface(test::icosphere(6, 33, glm::vec3(0)), 0.45);
  std::vector<glm::vec3> irradiance = test::irradianceOn(samples, terminator);
  HierarchicalIntegral integral{samples, irradiance};

  glm::vec3 at(std::size_t i, const RadialProfile& profile, const IntegralOptions& options) const {
    return integral.at(samples.positions[i], samples.normals[i], profile, options);
  }
};

TEST(RadialProfile, TableFollowsTheFormula) {
  const GaussianSum sum = literatureSkin();
  const RadialProfile profile = profileOf(sum);
  for (double r = 0; r < 12; r += 0.0137) {
    glm::dvec3 expected(0);
    for (std::size_t i = 0; i < GaussianSum::kCount; ++i)
      expected += sum.weights[i] * std::exp(-r * r / (2 * sum.variances[i])) /
                  (2 * std::numbers::pi * sum.variances[i]);
    EXPECT_LT(glm::distance(glm::dvec3(profile(float(r * r))), expected), 1e-4 * glm::length(expected) + 2e-5)
        << r;
  }
  EXPECT_LT(glm::length(profile(1e30f)), 1e-20f);
  EXPECT_NEAR(profileOf(sum, 2).total().x, 1 - 0.333, 1e-9);
}

TEST(HierarchicalIntegral, WithoutToleranceIsThePlainSum) {
  const SurfaceSamples samples = sampleSurface(test::icosphere(2, 10, glm::vec3(0)), 0.9);
  const auto irradiance = test::irradianceOn(samples, terminator);
  const HierarchicalIntegral integral(samples, irradiance);
  const Dipoles d = jensenDipoles();
  const RadialProfile profile = dipoleProfile();
  for (std::size_t i = 0; i < samples.size(); i += 97)
    for (const Reach reach : {Reach::full, Reach::local}) {
      glm::dvec3 sum(0), unit(0);
      for (std::size_t j = 0; j < samples.size(); ++j) {
        const bool local = isLocal(samples.normals[i], samples.normals[j]);
        const glm::dvec3 value =
            double(samples.areas[j]) *
            reflectance(d, double(glm::distance(samples.positions[i], samples.positions[j])));
        if (local || reach == Reach::full) sum += value * glm::dvec3(irradiance[j]);
        if (local) unit += value;
      }
      const auto found = [&](bool normalised) {
        return glm::dvec3(
            integral.at(samples.positions[i], samples.normals[i], profile, {0, reach, normalised}));
      };
      EXPECT_LT(glm::distance(found(false), sum), 2e-5);
      EXPECT_LT(glm::distance(found(true), sum * profile.total() / unit), 2e-5);
    }
}

TEST(HierarchicalIntegral, ErrorGrowsWithToleranceAsPublished) {
  const Head head;
  const RadialProfile profile = dipoleProfile();
  struct Row {
    double eps, most;
  };
  for (const Row& row : {Row{0.05, 0.0005}, Row{0.1, 0.0013}, Row{0.3, 0.0047}, Row{1, 0.022}}) {
    double squares = 0, count = 0;
    for (std::size_t i = 5; i < head.samples.size(); i += 1999, ++count) {
      const glm::vec3 exact = head.at(i, profile, {0, Reach::full, false});
      const float error = head.at(i, profile, {row.eps, Reach::full, false}).x - exact.x;
      squares += double(error * error);
    }
    EXPECT_LT(std::sqrt(squares / count), row.most) << row.eps;
    EXPECT_GT(count, 30);
  }
}

TEST(HierarchicalIntegral, EvenLightStaysEven) {
  SurfaceSamples samples = sampleSurface(test::plane(10, 10, 1), 0.3);
  for (std::size_t i = 0; i < samples.size(); ++i)  // a fold
    if (samples.positions[i].x > 3) samples.normals[i] = {-1, 0, 0};
  const std::vector<glm::vec3> even(samples.size(), glm::vec3(0.25f, 0.5f, 1));
  const HierarchicalIntegral integral(samples, even);
  const RadialProfile profile = profileOf(literatureSkin(), 2);
  for (std::size_t i = 0; i < samples.size(); i += 31) {
    const glm::vec3 light =
        integral.at(samples.positions[i], samples.normals[i], profile, {0.05, Reach::local, true});
    EXPECT_LT(glm::distance(glm::dvec3(light), profile.total() * glm::dvec3(0.25, 0.5, 1)), 1e-5);
  }
}

TEST(HierarchicalIntegral, TerminatorOfASphere) {
  const SurfaceSamples samples = sampleSurface(test::icosphere(5, 10, glm::vec3(0)), 0.05);
  const auto irradiance = test::irradianceOn(samples, terminator);
  const HierarchicalIntegral integral(samples, irradiance);
  const RadialProfile profile = profileOf(literatureSkin());
  for (const test::SkinValue& v : test::kSphere10) {
    const double angle = glm::radians(v.at);
    const glm::vec3 n(0, std::sin(angle), std::cos(angle));
    const glm::vec3 light = integral.at(10.f * n, n, profile, {});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(light[c]), v.light[c], 1.5e-3) << v.at << " colour " << c;
  }
}

TEST(HierarchicalIntegral, DarkSurfaceAndHalfPlane) {
  const SurfaceSamples samples = sampleSurface(test::plane(14, 14, 1), 0.04);
  const HierarchicalIntegral dark(samples, std::vector<glm::vec3>(samples.size(), glm::vec3(0)));
  const RadialProfile profile = profileOf(literatureSkin());
  EXPECT_EQ(dark.at({0, 0, 0}, {0, 0, 1}, profile, {}), glm::vec3(0));
  const auto half =
      test::irradianceOn(samples, [](const glm::vec3& p, const glm::vec3&) { return p.x > 0 ? 1 : 0; });
  const HierarchicalIntegral lit(samples, half);
  for (const test::SkinValue& v : test::kHalfPlane) {
    const glm::vec3 light = lit.at({float(v.at), 0.02f, 0}, {0, 0, 1}, profile, {});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(light[c]), v.light[c], 3e-3) << v.at << " colour " << c;
  }
}

TEST(HierarchicalIntegral, RefusesNonsense) {
  test::expectError([] { HierarchicalIntegral(SurfaceSamples(), {}); }, "samples");
  const SurfaceSamples samples = sampleSurface(test::plane(1, 1, 1), 0.5);
  test::expectError([&] { HierarchicalIntegral(samples, {}); }, "irradiance");
}

}  // namespace
}  // namespace sonoskin
