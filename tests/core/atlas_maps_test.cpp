#include "core/mesh/atlas/atlas_maps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/closest_point.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

SurfaceTraits plainTraits(const Mesh& mesh) {
  return {std::vector<glm::vec4>(mesh.positions.size(), {0, 0, 1, 1}),
          std::vector<float>(mesh.positions.size(), 0.1f)};
}

// A flat square of 20 mm that looks to `front`'s side, -y.
Mesh square() {
  Mesh mesh;
  mesh.positions = {{0, 5, 0}, {20, 5, 0}, {20, 5, 20}, {0, 5, 20}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  computeNormals(mesh);
  return mesh;
}

AtlasOptions fromFront() {
  AtlasOptions options;
  options.front = {0, -1, 0};
  return options;
}

glm::vec4 lookUp(const AtlasMaps& maps, const std::vector<glm::vec4>& map, const glm::vec2& p) {
  const glm::ivec2 low(glm::floor(p - 0.5f));
  const glm::vec2 f = p - 0.5f - glm::vec2(low);
  const auto at = [&](int x, int y) {
    return map[std::size_t(low.y + y) * std::size_t(maps.size.x) + std::size_t(low.x + x)];
  };
  return (1 - f.y) * ((1 - f.x) * at(0, 0) + f.x * at(1, 0)) + f.y * ((1 - f.x) * at(0, 1) + f.x * at(1, 1));
}

TEST(AtlasMaps, OfASquareAreThatSquare) {
  const Mesh mesh = square();
  const Atlas atlas = buildAtlas(mesh, fromFront());
  const AtlasMaps maps = bakeAtlas(mesh, plainTraits(mesh), atlas);
  ASSERT_EQ(maps.position.size(), std::size_t(atlas.size.x) * std::size_t(atlas.size.y));
  std::size_t owned = 0;
  for (std::size_t i = 0; i < maps.position.size(); ++i) {
    if (maps.position[i].w == 0) {
      EXPECT_FLOAT_EQ(maps.stretch[i].x, 0.15f);
      continue;
    }
    EXPECT_NEAR(maps.position[i].y, 5, 1e-4);
    EXPECT_NEAR(maps.normal[i].y, -1, 1e-5);
    EXPECT_NEAR(maps.normal[i].w, 0.1, 1e-5);
    EXPECT_NEAR(maps.stretch[i].x, 0.15, 1e-4);
    EXPECT_NEAR(maps.stretch[i].y, 0.15, 1e-4);
    owned += maps.position[i].w == 1;
  }
  EXPECT_NEAR(double(owned) * 0.15 * 0.15, 400, 6);
}

TEST(AtlasMaps, LookedUpBetweenTexelsGiveTheSurfaceUpToItsBorder) {
  const Mesh mesh = square();
  const Atlas atlas = buildAtlas(mesh, fromFront());
  const AtlasMaps maps = bakeAtlas(mesh, plainTraits(mesh), atlas);
  for (std::size_t t = 0; t < 2; ++t)
    for (int a = 0; a <= 20; ++a)
      for (int b = 0; b <= 20 - a; ++b) {
        const glm::vec3 w = glm::vec3(a, b, 20 - a - b) / 20.f;
        const Corners& c = atlas.corners[t];
        const auto& [i, j, k] = mesh.triangles[t];
        const glm::vec3 truth = w.x * mesh.positions[i] + w.y * mesh.positions[j] + w.z * mesh.positions[k];
        const glm::vec4 found = lookUp(maps, maps.position, w.x * c[0] + w.y * c[1] + w.z * c[2]);
        EXPECT_LT(glm::length(glm::vec3(found) - truth), 1e-3f);
        EXPECT_GE(found.w, 0.499f);
      }
}

// Skirts of folded surfaces can show another sheet beside a chart's border.
TEST(AtlasMaps, SkirtsThatShowAnotherPlaceLeaveBordersAlone) {
  Mesh mesh = square();
  for (std::uint32_t v = 0; v < 4; ++v) mesh.positions.push_back(mesh.positions[v] + glm::vec3(0, 3, 0));
  mesh.triangles.insert(mesh.triangles.end(), {{4, 5, 6}, {4, 6, 7}});
  computeNormals(mesh);
  Atlas atlas = buildAtlas(mesh, fromFront());
  for (std::uint32_t t = 0; t < 2; ++t) {  // the far square is drawn all around the near one
    Corners around = atlas.corners[t];
    const glm::vec2 middle = 0.5f * (atlas.corners[0][0] + atlas.corners[0][2]);
    for (glm::vec2& c : around) c = middle + 1.1f * (c - middle);
    atlas.skirts.push_back(t + 2);
    atlas.skirtChart.push_back(atlas.chart[t]);
    atlas.skirtCorners.push_back(around);
  }
  const AtlasMaps maps = bakeAtlas(mesh, plainTraits(mesh), atlas);
  std::size_t elsewhere = 0;
  for (const glm::vec4& p : maps.position) elsewhere += p.w == 0.5f && p.y > 7.9f;
  EXPECT_GT(elsewhere, 500u);  // the skirts are there
  for (std::uint32_t t = 0; t < 2; ++t)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_LT(glm::distance(glm::vec3(lookUp(maps, maps.position, atlas.corners[t][i])),
                              mesh.positions[mesh.triangles[t][i]]),
                1e-3f);
}

TEST(AtlasMaps, TexelsOfASphereLieOnItEverywhereThatAnythingIsRead) {
  const Mesh ball = test::icosphere(5, 20, {1, 2, 3});
  const Atlas atlas = buildAtlas(ball, {});
  const AtlasMaps maps = bakeAtlas(ball, plainTraits(ball), atlas);
  std::size_t skirts = 0;
  for (std::size_t i = 0; i < maps.position.size(); ++i) {
    EXPECT_GT(std::min(maps.stretch[i].x, maps.stretch[i].y), 0.2f * 0.15f);
    if (maps.position[i].w == 0) continue;
    const glm::vec3 away = glm::vec3(maps.position[i]) - glm::vec3(1, 2, 3);
    EXPECT_NEAR(glm::length(away), 20, 0.25);
    const Triangle& shown = ball.triangles[maps.triangle[i]];
    const glm::vec3 p(maps.position[i]),
        on = closestPointOnTriangle(p, ball.positions[shown[0]], ball.positions[shown[1]],
                                    ball.positions[shown[2]])
                 .position;
    EXPECT_LT(glm::distance(p, on), maps.position[i].w == 1 ? 1e-3f : 0.75f);
    EXPECT_GT(glm::dot(glm::normalize(away), glm::vec3(maps.normal[i])), 0.99f);
    skirts += maps.position[i].w == 0.5f;
  }
  EXPECT_GT(skirts, maps.position.size() / 10);
  // Also across seams, read with the coordinates of either side.
  for (std::size_t t = 0; t < ball.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec4 found = lookUp(maps, maps.position, atlas.corners[t][i]);
      EXPECT_LT(glm::length(glm::vec3(found) - ball.positions[ball.triangles[t][i]]), 0.05f);
    }
}

TEST(AtlasMaps, StretchIsThatOfTheSlope) {
  Mesh mesh = square();
  for (glm::vec3& p : mesh.positions) p.y += 0.6f * p.x;  // along u only
  computeNormals(mesh);
  AtlasOptions options = fromFront();
  const Atlas atlas = buildAtlas(mesh, options);
  const AtlasMaps maps = bakeAtlas(mesh, plainTraits(mesh), atlas);
  const float along = 0.15f * std::sqrt(1.36f);
  std::size_t owned = 0;
  for (std::size_t i = 0; i < maps.position.size(); ++i)
    if (maps.position[i].w == 1) {
      ++owned;
      EXPECT_NEAR(std::max(maps.stretch[i].x, maps.stretch[i].y), along, 2e-3);
      EXPECT_NEAR(std::min(maps.stretch[i].x, maps.stretch[i].y), 0.15, 2e-3);
    }
  EXPECT_GT(owned, 1000u);
}

TEST(AtlasMaps, SameWithAnyNumberOfThreads) {
  const Mesh ball = test::icosphere(4, 20, {0, 0, 0});
  const Atlas atlas = buildAtlas(ball, {});
  setThreadCount(1);
  const SurfaceTraits traits = measureTraits(ball, 32);
  const AtlasMaps one = bakeAtlas(ball, traits, atlas);
  setThreadCount(3);
  const SurfaceTraits same = measureTraits(ball, 32);
  const AtlasMaps three = bakeAtlas(ball, same, atlas);
  setThreadCount(0);
  EXPECT_EQ(traits.occlusion, same.occlusion);
  EXPECT_EQ(traits.curvature, same.curvature);
  EXPECT_EQ(one.position, three.position);
  EXPECT_EQ(one.normal, three.normal);
  EXPECT_EQ(one.stretch, three.stretch);
  EXPECT_EQ(one.triangle, three.triangle);
}

TEST(AtlasMaps, NeedNormalsAndTraitsAndCanBeCancelled) {
  Mesh mesh = square();
  const Atlas atlas = buildAtlas(mesh, fromFront());
  EXPECT_THROW(bakeAtlas(mesh, {}, atlas), Error);
  const SurfaceTraits traits = plainTraits(mesh);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(bakeAtlas(mesh, traits, atlas, Progress(sink)), Cancelled);
  EXPECT_THROW(measureTraits(mesh, 16, 2, Progress(sink)), Cancelled);
  mesh.normals.clear();
  EXPECT_THROW(bakeAtlas(mesh, traits, atlas), Error);
}

}  // namespace
}  // namespace sonoskin
