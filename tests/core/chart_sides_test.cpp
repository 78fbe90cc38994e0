#include "core/skin/chart_sides.h"

#include <gtest/gtest.h>

#include "tests/support/blocks.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

// A ball with deep grooves: normals turn within a texel. Turned about y its charts lie elsewhere.
std::shared_ptr<const SkinSurface> groovedBall(float turn) {
  Mesh mesh = test::icosphere(4, 1, glm::vec3(0));
  for (glm::vec3& p : mesh.positions) p *= 8 - 2 * std::exp(-20 * p.x * p.x) - std::exp(-30 * p.y * p.y);
  const float c = std::cos(turn), s = std::sin(turn);
  for (glm::vec3& p : mesh.positions) p = {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
  mesh.normals.clear();
  computeNormals(mesh);
  SkinQuality quality;
  quality.texel = 0.3;
  return prepareSkin(std::make_shared<const Mesh>(std::move(mesh)), {0, 0, 1}, quality);
}

float cosine(const glm::vec3&, const glm::vec3& n) { return std::max(0.f, glm::dot(n, {0.6f, 0, 0.8f})); }

struct Fit {
  std::shared_ptr<const SkinSurface> surface;
  ChartSides sides{*surface};
  std::vector<glm::vec4> light;  // as it is on the sides
  explicit Fit(float turn = 0) : surface(groovedBall(turn)) {
    const Mesh& mesh = *surface->mesh;
    for (const ChartSides::Place& p : sides.places()) {
      const auto& [i, j, k] = mesh.triangles[p.triangle];
      const auto mix = [&](const auto& of) {
        return p.weights.x * of[i] + p.weights.y * of[j] + p.weights.z * of[k];
      };
      light.emplace_back(glm::vec3(cosine(mix(mesh.positions), glm::normalize(mix(mesh.normals)))), 1);
    }
  }
  double errorOf(const std::vector<glm::vec4>& map) const {
    double squares = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
      const ChartSides::Place& p = sides.places()[i];
      const glm::vec2 place = placeInAtlas(surface->atlas.corners[p.triangle], p.weights);
      squares += std::pow(double(readAtlas(map, surface->maps.size, place).x - light[i].x), 2);
    }
    return std::sqrt(squares / double(light.size()));
  }
};

// How much is left depends on where charts end by chance: 0.18 to 0.38 of it, ball by ball.
TEST(ChartSides, LooksFindTheLightOfTheSides) {
  double before = 0, after = 0;  // squares
  for (int turn = 0; turn < 6; ++turn) {
    const Fit fit(0.13f * float(turn));
    ASSERT_GT(fit.sides.places().size(), 1000u);
    std::vector<glm::vec4> map = test::irradianceIn(*fit.surface, cosine);
    before += std::pow(fit.errorOf(map), 2);
    fit.sides.fit(fit.light, map);
    after += std::pow(fit.errorOf(map), 2);
    EXPECT_LT(fit.errorOf(map), 0.003) << turn;
  }
  EXPECT_LT(std::sqrt(after), 0.3 * std::sqrt(before));
}

TEST(ChartSides, OnlyTexelsAroundTheSidesChange) {
  const Fit fit;
  const std::vector<glm::vec4> before = test::irradianceIn(*fit.surface, cosine);
  std::vector<glm::vec4> after = before;
  fit.sides.fit(fit.light, after);
  std::vector<bool> around(before.size(), false);
  for (const ChartSides::Place& p : fit.sides.places())
    for (const std::uint32_t texel : p.look.texels) around[texel] = true;
  for (std::size_t t = 0; t < before.size(); ++t) {
    EXPECT_NEAR(after[t].a, before[t].a, 1e-6);
    EXPECT_TRUE(around[t] || after[t] == before[t]) << t;
    EXPECT_GE(after[t].x, 0);
  }
}

TEST(ChartSides, EvenLightStaysEven) {
  const Fit fit;
  const std::vector<glm::vec4> light(fit.light.size(), glm::vec4(0.5f, 0.5f, 0.5f, 1));
  const auto even = [](const glm::vec3&, const glm::vec3&) { return 0.5f; };
  const std::vector<glm::vec4> before = test::irradianceIn(*fit.surface, even);
  std::vector<glm::vec4> after = before;
  fit.sides.fit(light, after);
  for (std::size_t t = 0; t < before.size(); ++t) ASSERT_LT(glm::distance(after[t], before[t]), 1e-6f) << t;
}

// A triangle that lies in the atlas under another one, far away: it must not change what that one shows.
TEST(ChartSides, AnotherSheetIsLeftAlone) {
  auto surface = std::make_shared<SkinSurface>(*test::surfaceInBlocks(test::icosphere(0, 5, {0, 0, 0}), 8));
  surface->pointBased = false;
  surface->atlas.texel = 0.1f;
  surface->atlas.chart.resize(surface->mesh->triangles.size());
  for (std::uint32_t t = 0; t < surface->atlas.chart.size(); ++t) surface->atlas.chart[t] = t;
  const std::size_t places = ChartSides(*surface).places().size();
  EXPECT_GT(places, 0u);
  surface->atlas.corners[0] = surface->atlas.corners[10];  // across the ball
  const ChartSides sides(*surface);
  EXPECT_LT(sides.places().size(), places);
  for (const ChartSides::Place& p : sides.places()) EXPECT_NE(p.triangle, 0u);
}

TEST(ChartSides, BlocksHaveNone) {
  const auto surface = test::surfaceInBlocks(test::icosphere(1, 5, {0, 0, 0}), 8);
  EXPECT_TRUE(ChartSides(*surface).places().empty());
}

}  // namespace
}  // namespace sonoskin
