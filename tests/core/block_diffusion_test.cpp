#include "core/skin/block_diffusion.h"

#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/skin/brute_force.h"
#include "core/skin/shown_places.h"
#include "core/skin/triangle_lattice.h"
#include "tests/support/blocks.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"
#include "tests/support/skin_tables.h"

namespace sonoskin {
namespace {

float cosine(const glm::vec3&, const glm::vec3& n) { return std::max(0.f, n.x); }

// RMS of red between the texels' light and the truth, at every `step`-th owned texel.
double errorOf(const SkinSurface& surface, const PointDiffusion::Levels& levels, std::size_t step) {
  std::vector<DiffusionTarget> targets;
  std::vector<DiffusedLevels> found;
  for (std::size_t t = 0; t < surface.maps.position.size(); t += step) {
    if (surface.maps.position[t].w != 1) continue;
    const glm::vec3 p(surface.maps.position[t]), n(surface.maps.normal[t]);
    targets.push_back({p, n, glm::vec3(cosine(p, n))});
    found.push_back({targets.back().irradiance});
    for (std::size_t i = 0; i < levels.size(); ++i) found.back()[i + 1] = glm::vec3(levels[i][t]);
  }
  const SurfaceSamples fine = sampleSurface(*surface.mesh, 0.11);
  const auto exact =
      bruteForceDiffusion(fine, test::irradianceOn(fine, cosine), literatureSkin(), targets, Reach::local);
  double squares = 0;
  for (std::size_t t = 0; t < targets.size(); ++t)
    squares += std::pow(
        double(sumOfLevels(literatureSkin(), found[t]).x - sumOfLevels(literatureSkin(), exact[t]).x), 2);
  EXPECT_GT(targets.size(), 300u);
  return std::sqrt(squares / double(targets.size()));
}

TEST(BlockDiffusion, FollowsBruteForceOnFineAndCoarseTriangles) {
  for (const int level : {5, 3}) {  // sides of 0.5 and 2 mm
    const auto surface = test::surfaceInBlocks(test::icosphere(level, 13, {1, 2, 3}), level == 5 ? 6 : 14);
    BlockDiffusion kept;
    const auto levels =
        levelsInBlocks(surface, literatureSkin(), {test::irradianceIn(*surface, cosine)}, kept);
    EXPECT_LT(errorOf(*surface, levels, level == 5 ? 997 : 97), 1.2e-3) << level;
  }
}

TEST(BlockDiffusion, EvenLightStaysEvenInEveryTexel) {
  Mesh mesh = test::icosphere(4, 8, glm::vec3(0));
  mesh.triangles.resize(mesh.triangles.size() / 2);
  const auto surface = test::surfaceInBlocks(mesh, 8);
  BlockDiffusion kept;
  const auto white = [](const glm::vec3&, const glm::vec3&) { return 1.f; };
  for (const auto& level :
       levelsInBlocks(surface, literatureSkin(), {test::irradianceIn(*surface, white)}, kept)) {
    ASSERT_EQ(level.size(), surface->maps.position.size());
    std::vector<float> expected(level.size(), 0);
    for (const std::uint32_t t : coveredTexels(surface->maps)) expected[t] = 1;
    for (std::size_t t = 0; t < level.size(); ++t) ASSERT_LT(glm::length(level[t] - expected[t]), 1e-5f) << t;
  }
}

TEST(BlockDiffusion, KeepsItsPointsAndForgetsTheLight) {
  const auto surface = test::surfaceInBlocks(test::icosphere(3, 5, glm::vec3(0)), 6);
  const auto half = [](const glm::vec3& p, const glm::vec3&) { return p.z > 0 ? 1.f : 0.f; };
  const auto light = test::irradianceIn(*surface, half);
  BlockDiffusion kept, fresh;
  levelsInBlocks(surface, literatureSkin(), {test::irradianceIn(*surface, cosine)}, kept);
  const auto* state = kept.state.get();
  const PointDiffusion::Levels again = levelsInBlocks(surface, literatureSkin(), {light}, kept);
  EXPECT_EQ(kept.state.get(), state);
  setThreadCount(1);
  EXPECT_EQ(again, levelsInBlocks(surface, literatureSkin(), {light}, fresh));
  setThreadCount(0);
  EXPECT_GT(kept.bytes(), 100000u);
  const GaussianSum wide = scaledByWidth(literatureSkin(), 2);
  EXPECT_NE(again, levelsInBlocks(surface, wide, {light}, kept));
}

TEST(BlockDiffusion, NarrowGaussiansLeaveTheIrradiance) {
  const auto surface = test::surfaceInBlocks(test::icosphere(3, 5, glm::vec3(0)), 6);
  const auto light = test::irradianceIn(*surface, cosine);
  BlockDiffusion kept;
  const GaussianSum none = scaledByWidth(literatureSkin(), 0);
  for (const auto& level : levelsInBlocks(surface, none, {light}, kept))
    for (const std::uint32_t t : coveredTexels(surface->maps)) ASSERT_EQ(level[t], light[t]) << t;
}

// A sum of levels is what its levels come to, and thinness is spread as light is.
TEST(BlockDiffusion, SumsLevelsAndSpreadsThinnessBesideThem) {
  const auto surface = test::surfaceInBlocks(test::icosphere(4, 8, glm::vec3(0)), 8);
  const auto light = test::irradianceIn(*surface, cosine);
  BlockDiffusion kept;
  const GaussianSum skin = literatureSkin();
  const auto sum = diffuseInBlocks(surface, skin, {light, light}, sumWeights(skin), kept);
  const auto levels = levelsInBlocks(surface, skin, {light}, kept);
  const int smooth = PointDiffusion::smoothLevel(skin);
  ASSERT_EQ(smooth, 3);
  for (const std::uint32_t t : coveredTexels(surface->maps)) {
    glm::vec3 expected(0);
    for (std::size_t i = 0; i < levels.size(); ++i)
      expected += glm::vec3(skin.weights[i + 1]) * glm::vec3(levels[i][t]);
    ASSERT_LT(glm::distance(glm::vec3(sum[t]), expected), 1e-5f) << t;
    ASSERT_NEAR(sum[t].a, levels[std::size_t(smooth - 1)][t].r, 1e-5f) << t;
  }
}

// A profile without a level as wide as thinness is smoothed has one more.
TEST(BlockDiffusion, ThinnessHasALevelOfItsOwn) {
  const auto surface = test::surfaceInBlocks(test::icosphere(4, 8, glm::vec3(0)), 8);
  const auto light = test::irradianceIn(*surface, cosine);
  const GaussianSum skin = literatureSkin(), narrow = scaledByWidth(skin, 0.5);
  ASSERT_EQ(PointDiffusion::smoothLevel(narrow), PointDiffusion::kSmooth);
  BlockDiffusion kept, keptNarrow;
  const auto usual = diffuseInBlocks(surface, skin, {light, light}, sumWeights(skin), kept);
  const auto own = diffuseInBlocks(surface, narrow, {light, light}, sumWeights(narrow), keptNarrow);
  double difference = 0;
  for (const std::uint32_t t : coveredTexels(surface->maps)) {
    difference = std::max(difference, std::abs(double(usual[t].r - own[t].r)));
    ASSERT_NEAR(usual[t].a, own[t].a, 2e-3) << t;
  }
  EXPECT_GT(difference, 0.02);
}

TEST(BlockDiffusion, RefusesNonsenseAndCanBeCancelled) {
  const auto surface = test::surfaceInBlocks(test::icosphere(2, 5, glm::vec3(0)), 6);
  BlockDiffusion kept;
  test::expectError([&] { levelsInBlocks(surface, literatureSkin(), {{}}, kept); }, "irradiance");
  ProgressSink sink;
  sink.cancel = true;
  const auto light = test::irradianceIn(*surface, cosine);
  EXPECT_THROW(levelsInBlocks(surface, literatureSkin(), {light}, kept, Progress(sink)), Cancelled);
  EXPECT_FALSE(kept.state);
}

TEST(TriangleLattice, LinearFunctionsAreReadExactly) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0.1f, 2, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {2, 0, 3}};
  for (const double longest : {10.0, 1.5, 0.31}) {
    const TriangleLattice lattice(mesh, longest);
    const auto f = [](const glm::vec3& p) { return 2 * p.x - 3 * p.y + 1; };
    std::vector<float> values;
    for (const glm::vec3& p : lattice.positions()) values.push_back(f(p));
    for (std::uint32_t t = 0; t < 2; ++t)
      for (int i = 0; i <= 20; ++i)
        for (int j = 0; i + j <= 20; ++j) {
          const glm::vec3 w(float(20 - i - j) / 20, float(i) / 20, float(j) / 20);
          const Triangle& c = mesh.triangles[t];
          const glm::vec3 p =
              w.x * mesh.positions[c[0]] + w.y * mesh.positions[c[1]] + w.z * mesh.positions[c[2]];
          ASSERT_NEAR(lattice.value(values, c, t, w), f(p), 1e-4) << longest << " " << i << " " << j;
        }
  }
}

}  // namespace
}  // namespace sonoskin
