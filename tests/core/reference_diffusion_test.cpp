#include "core/skin/reference_diffusion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/parallel.h"
#include "core/skin/brute_force.h"
#include "tests/support/blocks.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"
#include "tests/support/skin_tables.h"

namespace sonoskin {
namespace {

float cosine(const glm::vec3&, const glm::vec3& n) { return std::max(0.f, n.x); }

TEST(ReferenceDiffusion, EqualsBruteForce) {
  const auto surface = test::surfaceInBlocks(test::icosphere(3, 8, {1, 2, 3}), 8);
  const auto light = referenceDiffusion(*surface, literatureSkin(), test::irradianceIn(*surface, cosine));
  std::vector<DiffusionTarget> targets;
  std::vector<glm::vec3> found;
  for (std::size_t t = 0; t < light.size(); t += 211) {
    if (surface->maps.position[t].w != 1) continue;
    EXPECT_EQ(light[t].a, 1);
    const glm::vec3 p(surface->maps.position[t]), n(surface->maps.normal[t]);
    targets.push_back({p, n, glm::vec3(cosine(p, n))});
    found.emplace_back(light[t]);
  }
  const SurfaceSamples fine = sampleSurface(*surface->mesh, 0.11);
  const auto exact =
      bruteForceDiffusion(fine, test::irradianceOn(fine, cosine), literatureSkin(), targets, Reach::full);
  ASSERT_GT(targets.size(), 100u);
  for (std::size_t t = 0; t < targets.size(); ++t)
    EXPECT_LT(glm::distance(found[t], sumOfLevels(literatureSkin(), exact[t])), 4e-3f) << t;
}

// But for what passes through from the far side of the sphere: 1e-4.
TEST(ReferenceDiffusion, EvenLightStaysEven) {
  Mesh mesh = test::icosphere(3, 8, glm::vec3(0));
  mesh.triangles.resize(mesh.triangles.size() / 2);
  const auto surface = test::surfaceInBlocks(mesh, 6);
  const auto even = test::irradianceIn(*surface, [](const glm::vec3&, const glm::vec3&) { return 0.5f; });
  for (const auto& light : {referenceDiffusion(*surface, literatureSkin(), even),
                            referenceDiffusion(*surface, scaledByWidth(literatureSkin(), 0), even)})
    for (std::size_t t = 0; t < light.size(); ++t)
      if (light[t].a > 0 || surface->maps.position[t].w == 1) {
        ASSERT_LT(glm::distance(light[t], glm::vec4(0.5f, 0.5f, 0.5f, 1)), 3e-4f) << t;
      }
}

TEST(ReferenceDiffusion, DipoleOfAHalfLitPlane) {
  const auto surface = test::surfaceInBlocks(test::plane(15, 15, 1), 8);
  const auto half = [](const glm::vec3& p, const glm::vec3&) {
    return std::clamp(0.5f + 1e3f * p.x, 0.f, 1.f);
  };
  const auto light = referenceDiffusion(*surface, jensenSkin(), test::irradianceIn(*surface, half));
  const MediumRgb medium = jensenSkin();
  int seen = 0;
  for (std::size_t t = 0; t < light.size(); ++t) {
    const glm::vec4& p = surface->maps.position[t];
    if (p.w != 1 || std::abs(p.y) > 0.05f || std::abs(p.x) > 3) continue;
    for (int c = 0; c < 3; ++c) {
      const Dipole d = makeDipole(medium[std::size_t(c)]);
      // The plane ends 15 mm away, where red still spreads a little.
      EXPECT_NEAR(double(light[t][c]), reflectanceOfHalfPlane(d, double(p.x)) / totalReflectance(d), 0.012)
          << p.x;
    }
    ++seen;
  }
  EXPECT_GT(seen, 20);
}

TEST(ReferenceDiffusion, DoesNotDependOnThreadsRefusesNonsenseAndCanBeCancelled) {
  const auto surface = test::surfaceInBlocks(test::icosphere(2, 4, glm::vec3(0)), 6);
  const auto irradiance = test::irradianceIn(*surface, cosine);
  setThreadCount(1);
  const auto one = referenceDiffusion(*surface, literatureSkin(), irradiance);
  setThreadCount(3);
  EXPECT_EQ(one, referenceDiffusion(*surface, literatureSkin(), irradiance));
  setThreadCount(0);
  test::expectError([&] { referenceDiffusion(*surface, literatureSkin(), {}); }, "irradiance");
  ProgressSink sink;
  std::vector<double> reports;
  sink.report = [&](double f) {
    reports.push_back(f);
    if (f > 0.5) sink.cancel = true;
  };
  EXPECT_THROW(referenceDiffusion(*surface, literatureSkin(), irradiance, Progress(sink)), Cancelled);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
}

}  // namespace
}  // namespace sonoskin
