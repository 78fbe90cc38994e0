#include "core/skin/brute_force.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/base/parallel.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"
#include "tests/support/skin_tables.h"

namespace sonoskin {
namespace {

void expectLight(const glm::vec3& light, const glm::dvec3& expected, double tolerance, double where) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(double(light[c]), expected[c], tolerance) << "colour " << c << " at " << where;
}

// A plane that is lit somehow, fine enough for the narrowest Gaussian.
class LitPlane {
 public:
  LitPlane() : samples_(sampleSurface(test::plane(14, 14, 1), 0.025)) {}
  template <class F>
  glm::vec3 lightAt(double x, F&& irradiance) const {
    const std::vector<DiffusionTarget> targets{{{float(x), 0, 0}, {0, 0, 1}, glm::vec3(-1e3f)}};
    const auto of =
        test::irradianceOn(samples_, [&](const glm::vec3& p, const glm::vec3&) { return irradiance(p); });
    return sumOfLevels(literatureSkin(),
                       bruteForceDiffusion(samples_, of, literatureSkin(), targets, Reach::local)[0]);
  }

 private:
  SurfaceSamples samples_;
};

TEST(BruteForce, HalfPlane) {
  const LitPlane plane;
  for (const test::SkinValue& v : test::kHalfPlane)
    expectLight(plane.lightAt(v.at, [](const glm::vec3& p) { return p.x > 0 ? 1 : 0; }), v.light, 1e-3, v.at);
}

TEST(BruteForce, SineLosesAmplitude) {
  const LitPlane plane;
  for (const test::SkinValue& v : test::kSine) {
    const double k = 2 * std::numbers::pi / v.at;
    const auto light = plane.lightAt(0, [&](const glm::vec3& p) { return std::cos(k * double(p.x)); });
    expectLight(light, v.light, 1e-3, v.at);
  }
}

TEST(BruteForce, MiddleOfADisk) {
  const LitPlane plane;
  for (const test::SkinValue& v : test::kDisk) {
    const auto lit = [&](const glm::vec3& p) { return double(glm::length(p)) < v.at ? 1 : 0; };
    expectLight(plane.lightAt(0, lit), v.light, 2e-3, v.at);
  }
}

// The terminator on a sphere; samples every `spacing` mm.
template <class Table>
void expectSphere(const Table& table, float radius, double spacing, int colours, double tolerance) {
  const SurfaceSamples samples = sampleSurface(test::icosphere(5, radius, glm::vec3(0)), spacing);
  const auto irradiance =
      test::irradianceOn(samples, [](const glm::vec3&, const glm::vec3& n) { return std::max(0.f, n.z); });
  std::vector<DiffusionTarget> targets;
  for (const test::SkinValue& v : table) {
    const double angle = glm::radians(v.at);
    const glm::vec3 n(0, std::sin(angle), std::cos(angle));
    targets.push_back({radius * n, n, glm::vec3(std::max(0.f, n.z))});
  }
  const auto levels = bruteForceDiffusion(samples, irradiance, literatureSkin(), targets, Reach::full);
  for (std::size_t i = 0; i < table.size(); ++i)
    for (int c = 0; c < colours; ++c)
      EXPECT_NEAR(double(sumOfLevels(literatureSkin(), levels[i])[c]), table[i].light[c], tolerance)
          << "colour " << c << " at " << table[i].at << " degrees";
}

TEST(BruteForce, TerminatorOfASphere) {
  expectSphere(test::kSphere10, 10, 0.05, 3, 3e-4);
  expectSphere(test::kSphere20, 20, 0.15, 1, 6e-4);  // the narrowest Gaussian is left out: 4e-4 at 90 degrees
}

TEST(BruteForce, EvenLightStaysEvenUpToTheBorder) {
  const SurfaceSamples samples = sampleSurface(test::plane(8, 8, 1), 0.1);
  const std::vector<glm::vec3> even(samples.size(), glm::vec3(0.25f, 0.5f, 1));
  const std::vector<DiffusionTarget> targets{{{0, 0, 0}, {0, 0, 1}, {0.25f, 0.5f, 1}},
                                             {{8, 8, 0}, {0, 0, 1}, {0.25f, 0.5f, 1}}};
  for (const DiffusedLevels& levels :
       bruteForceDiffusion(samples, even, literatureSkin(), targets, Reach::local))
    for (const glm::vec3& level : levels) EXPECT_LT(glm::distance(level, {0.25f, 0.5f, 1}), 1e-5f);
}

TEST(BruteForce, LightPassesThinPartsOnlyInFullReach) {
  Mesh sheet = test::plane(10, 10, 1);
  const Mesh front = sheet;
  for (std::size_t i = 0; i < front.positions.size();
       ++i) {  // a back side 2 mm below that faces the other way
    sheet.positions.push_back(front.positions[i] - glm::vec3(0, 0, 2));
    sheet.normals.push_back(-front.normals[i]);
  }
  const auto count = std::uint32_t(front.positions.size());
  for (const Triangle& t : front.triangles)
    sheet.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
  const SurfaceSamples samples = sampleSurface(sheet, 0.2);
  const auto backLit =
      test::irradianceOn(samples, [](const glm::vec3& p, const glm::vec3&) { return p.z < -1 ? 1 : 0; });
  const std::vector<DiffusionTarget> targets{{{0, 0, 0}, {0, 0, 1}, glm::vec3(0)}};
  const auto lightOf = [&](Reach reach) {
    return sumOfLevels(literatureSkin(),
                       bruteForceDiffusion(samples, backLit, literatureSkin(), targets, reach)[0]);
  };
  EXPECT_EQ(lightOf(Reach::local), glm::vec3(0));
  expectLight(lightOf(Reach::full), {0.1939, 0.0017, 0.0002}, 5e-4, 2);  // transmittance at 2 mm
}

TEST(BruteForce, UnresolvedGaussiansLeaveTheIrradiance) {
  const SurfaceSamples samples = sampleSurface(test::plane(8, 8, 1), 0.3);
  const std::vector<glm::vec3> dark(samples.size(), glm::vec3(0));
  const std::vector<DiffusionTarget> targets{{{0, 0, 0}, {0, 0, 1}, glm::vec3(1)}};
  const auto levels = bruteForceDiffusion(samples, dark, literatureSkin(), targets, Reach::local)[0];
  for (std::size_t i = 0; i < levels.size(); ++i) EXPECT_EQ(levels[i], glm::vec3(i < 2 ? 1 : 0)) << i;
  GaussianSum sharp = literatureSkin();
  sharp.variances.fill(0);
  EXPECT_EQ(bruteForceDiffusion(samples, dark, sharp, targets, Reach::full)[0][5], glm::vec3(1));
}

TEST(BruteForce, DoesNotDependOnThreadsAndCanBeCancelled) {
  const SurfaceSamples samples = sampleSurface(test::icosphere(3, 10, glm::vec3(0)), 0.5);
  const auto irradiance =
      test::irradianceOn(samples, [](const glm::vec3& p, const glm::vec3&) { return p.x * p.x; });
  std::vector<DiffusionTarget> targets;
  for (std::size_t i = 0; i < samples.size(); i += 50)
    targets.push_back({samples.positions[i], samples.normals[i], irradiance[i]});
  const auto run = [&](int threads) {
    setThreadCount(threads);
    const auto result = bruteForceDiffusion(samples, irradiance, literatureSkin(), targets, Reach::local);
    setThreadCount(0);
    return result;
  };
  EXPECT_EQ(run(1), run(3));
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(
      bruteForceDiffusion(samples, irradiance, literatureSkin(), targets, Reach::full, Progress(sink)),
      Cancelled);
  test::expectError([&] { bruteForceDiffusion(samples, {}, literatureSkin(), targets, Reach::full); },
                    "irradiance");
}

}  // namespace
}  // namespace sonoskin
