#include "core/mesh/atlas/atlas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

float area2(const Corners& c) {
  const glm::vec2 a = c[1] - c[0], b = c[2] - c[0];
  return 0.5f * (a.x * b.y - a.y * b.x);
}

float area3(const Mesh& mesh, const Triangle& t) {
  return 0.5f * glm::length(glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                       mesh.positions[t[2]] - mesh.positions[t[0]]));
}

// A sheet over [0, size]² with a vertex every mm, bent by `shape`.
template <class Shape>
Mesh sheet(int size, const Shape& shape) {
  Mesh mesh;
  for (int j = 0; j <= size; ++j)
    for (int i = 0; i <= size; ++i) mesh.positions.push_back(shape(float(i), float(j)));
  const auto at = [&](int i, int j) { return std::uint32_t(j * (size + 1) + i); };
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  computeNormals(mesh);
  return mesh;
}

void expectWhole(const Mesh& mesh, const Atlas& atlas) {
  ASSERT_EQ(atlas.corners.size(), mesh.triangles.size());
  ASSERT_EQ(atlas.chart.size(), mesh.triangles.size());
  ASSERT_EQ(atlas.skirts.size(), atlas.skirtCorners.size());
  ASSERT_EQ(atlas.skirts.size(), atlas.skirtChart.size());
  EXPECT_GT(atlas.size.x, 0);
  EXPECT_GT(atlas.size.y, 0);
  const auto expectInside = [&](const Corners& corners) {
    for (const glm::vec2& p : corners) {
      EXPECT_GE(std::min(p.x, p.y), 2.99f);
      EXPECT_LE(p.x, float(atlas.size.x) - 2.99f);
      EXPECT_LE(p.y, float(atlas.size.y) - 2.99f);
    }
  };
  for (const Corners& corners : atlas.corners) expectInside(corners);
  for (const Corners& corners : atlas.skirtCorners) expectInside(corners);
  for (std::size_t i = 0; i < atlas.skirts.size(); ++i)
    EXPECT_NE(atlas.skirtChart[i], atlas.chart[atlas.skirts[i]]) << "A chart is no skirt of itself.";
}

TEST(Atlas, SphereHasFewChartsThatAreStretchedNoMoreThanItsAxesAllow) {
  const Mesh ball = test::icosphere(5, 30, {1, 2, 3});
  const Atlas atlas = buildAtlas(ball, {});
  expectWhole(ball, atlas);
  EXPECT_LE(atlas.charts, 14);
  EXPECT_GE(atlas.charts, 6);
  const AtlasCheck check = checkAtlas(ball, atlas);
  EXPECT_TRUE(check.good());
  EXPECT_EQ(check.overlap, 0);
  EXPECT_EQ(check.uncovered, 0);
  EXPECT_EQ(check.steep, 0);
  // 36.2 degrees to the nearest of 14 axes, and the front may take what is 0.15 farther.
  EXPECT_LT(check.stretch99, 1 / (std::cos(36.2 * std::numbers::pi / 180) - 0.15));
  EXPECT_LT(check.stretchMax, 1.65);
  EXPECT_GT(check.seamLength, 2 * std::numbers::pi * 30);
}

TEST(Atlas, TrianglesKeepTheirOrientationAndTheAreaThatTheirAxisSees) {
  const Mesh ball = test::icosphere(4, 30, {0, 0, 0});
  const Atlas atlas = buildAtlas(ball, {});
  double flat = 0, seen = 0;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    const double texels = double(area2(atlas.corners[t])), area = double(area3(ball, ball.triangles[t]));
    EXPECT_GT(texels, 0);
    EXPECT_LE(texels * 0.15 * 0.15, area * 1.0001);
    flat += texels * 0.15 * 0.15;
    seen += area;
  }
  EXPECT_GT(flat, 0.8 * seen);
}

TEST(Atlas, NoPlaceOfTheAtlasBelongsToTwoTriangles) {
  const Mesh ball = test::icosphere(2, 20, {0, 0, 0});
  const Atlas atlas = buildAtlas(ball, {});
  const auto isInside = [](const Corners& c, const glm::vec2& p) {
    for (std::size_t i = 0; i < 3; ++i)
      if (area2({c[i], c[(i + 1) % 3], p}) <= 1e-3f) return false;
    return true;
  };
  for (std::size_t a = 0; a < atlas.corners.size(); ++a)
    for (std::size_t b = 0; b < atlas.corners.size(); ++b) {
      if (a == b) continue;
      const Corners& c = atlas.corners[b];
      EXPECT_FALSE(isInside(atlas.corners[a], (c[0] + c[1] + c[2]) / 3.f));
    }
}

TEST(Atlas, FoldedSheetIsSplit) {
  // Seen from the front, its middle third turns back behind the first: an S in depth.
  const Mesh fold = sheet(60, [](float x, float y) {
    const float s = x / 60;
    return glm::vec3(30 * s + 12 * std::sin(2 * 3.14159f * s), -20 * std::sin(3.14159f * (s - 0.5f)), y);
  });
  const AtlasCheck split = checkAtlas(fold, buildAtlas(fold, {}));
  EXPECT_LT(split.overlap, 0.01);
  EXPECT_LT(split.uncovered, 0.01);
}

TEST(Atlas, StairsThatWindAboveThemselvesAreSplit) {
  // All of it faces the front, is connected and lies over itself twice.
  const Mesh stairs = sheet(160, [](float x, float y) {
    const float angle = 0.08f * x, r = 5 + 0.1f * y;
    return glm::vec3(r * std::cos(angle), r * std::sin(angle), 0.5f * angle);
  });
  const Atlas atlas = buildAtlas(stairs, {});
  EXPECT_GE(atlas.charts, 2);
  const AtlasCheck check = checkAtlas(stairs, atlas);
  EXPECT_LT(check.overlap, 0.01);
  EXPECT_LT(check.uncovered, 0.01);
}

TEST(Atlas, SmallChartsDoNotJoinWhatTheyWouldLieOver) {
  // A strip whose end is turned back and lies 8 mm behind it: small, and only the strip and the turn are beside it.
  const Mesh hem = sheet(55, [](float x, float y) {
    const float turn = std::clamp((x - 36) / 12, 0.f, 1.f) * std::numbers::pi_v<float>;
    const float back = std::max(x - 48, 0.f);
    return glm::vec3(std::min(x, 36.f) + 4 * std::sin(turn) - back, 0.15f * y, 4 * std::cos(turn) - 4);
  });
  const AtlasCheck check = checkAtlas(hem, buildAtlas(hem, {}));
  EXPECT_LE(check.charts, 6);
  EXPECT_LT(check.overlap, 0.005);
  EXPECT_LT(check.uncovered, 0.005);
}

TEST(Atlas, NoiseDoesNotScatterCharts) {
  Mesh ball = test::icosphere(6, 30, {0, 0, 0});
  std::uint32_t state = 1;
  for (glm::vec3& p : ball.positions) {
    state = 1664525 * state + 1013904223;
    p *= 1 + 0.004f * (float(state >> 8) / float(1 << 23) - 1);  // up to 0.12 mm, a fifth of an edge
  }
  const Atlas atlas = buildAtlas(ball, {});
  EXPECT_LE(atlas.charts, 14);
  EXPECT_LT(checkAtlas(ball, atlas).seamLength, 1200);
}

TEST(Atlas, TurnedSurfaceWithItsFrontGetsTheSameAtlas) {
  Mesh ball = sheet(
      40, [](float x, float y) { return glm::vec3(x, 8 * std::sin(0.2f * x) * std::cos(0.15f * y), y); });
  AtlasOptions options;
  options.front = {0, -1, 0};
  const Atlas atlas = buildAtlas(ball, options);
  for (glm::vec3& p : ball.positions) p = {-p.y, p.x, p.z};
  options.front = {1, 0, 0};
  const Atlas turned = buildAtlas(ball, options);
  EXPECT_EQ(atlas.charts, turned.charts);
  EXPECT_EQ(atlas.size, turned.size);
  EXPECT_EQ(atlas.chart, turned.chart);
}

TEST(Atlas, SameWithAnyNumberOfThreads) {
  const Mesh ball = test::icosphere(5, 30, {0, 0, 0});
  setThreadCount(1);
  const Atlas one = buildAtlas(ball, {});
  setThreadCount(3);
  const Atlas three = buildAtlas(ball, {});
  setThreadCount(0);
  EXPECT_EQ(one.chart, three.chart);
  EXPECT_EQ(one.corners, three.corners);
  EXPECT_EQ(one.skirts, three.skirts);
  EXPECT_EQ(one.skirtCorners, three.skirtCorners);
}

TEST(Atlas, AnyMeshHasOne) {
  Mesh triangle;
  triangle.positions = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
  triangle.triangles = {{0, 1, 2}};
  Mesh degenerate = triangle;
  degenerate.triangles.push_back({0, 1, 1});
  degenerate.triangles.push_back({2, 2, 2});
  Mesh fan = triangle;  // three triangles at one edge
  fan.positions.insert(fan.positions.end(), {{0, 0, 10}, {0, -10, 0}});
  fan.triangles.insert(fan.triangles.end(), {{0, 1, 3}, {0, 1, 4}});
  Mesh pieces = test::icosphere(1, 3, {0, 0, 0});
  const Mesh other = test::icosphere(1, 3, {20, 0, 0});
  for (const Triangle& t : other.triangles) pieces.triangles.push_back({t[0] + 42, t[1] + 42, t[2] + 42});
  pieces.positions.insert(pieces.positions.end(), other.positions.begin(), other.positions.end());
  for (const Mesh& mesh : {Mesh{}, triangle, degenerate, fan, pieces, test::icosphere(2, 0.01f, {0, 0, 0})}) {
    const Atlas atlas = buildAtlas(mesh, {});
    expectWhole(mesh, atlas);
    const AtlasCheck check = checkAtlas(mesh, atlas);
    EXPECT_LT(check.overlap, 0.01);
    EXPECT_LE(check.charts, 60);
  }
}

TEST(Atlas, LargeSurfacesGetLargerTexels) {
  const Mesh ball = test::icosphere(4, 60, {0, 0, 0});
  AtlasOptions options;
  options.maxSize = 512;
  const Atlas atlas = buildAtlas(ball, options);
  EXPECT_LE(std::max(atlas.size.x, atlas.size.y), 512);
  EXPECT_GT(atlas.texel, 0.5f);
  EXPECT_LT(atlas.texel, 2);
}

TEST(Atlas, SkirtsReachAsFarAsAsked) {
  const Mesh ball = test::icosphere(5, 30, {0, 0, 0});
  AtlasOptions options;
  options.skirt = 0;
  EXPECT_TRUE(buildAtlas(ball, options).skirts.empty());
  options.skirt = 8;
  const Atlas atlas = buildAtlas(ball, options);
  // Each chart's vertices, and how far from them the chart's skirt goes.
  for (std::uint32_t chart = 0; chart < std::uint32_t(atlas.charts); ++chart) {
    std::vector<glm::vec3> own;
    for (std::size_t t = 0; t < ball.triangles.size(); ++t)
      if (atlas.chart[t] == chart) own.push_back(ball.positions[ball.triangles[t][0]]);
    float farthest = 0;
    for (std::size_t i = 0; i < atlas.skirts.size(); i += 7) {
      if (atlas.skirtChart[i] != chart) continue;
      const glm::vec3& p = ball.positions[ball.triangles[atlas.skirts[i]][0]];
      float nearest = 1e9f;
      for (const glm::vec3& q : own) nearest = std::min(nearest, glm::length(p - q));
      farthest = std::max(farthest, nearest);
    }
    EXPECT_GT(farthest, 5);
    EXPECT_LT(farthest, 11);
  }
}

TEST(Atlas, EveryTriangleFindsItsTexelsAgainWhenSplitAtSeams) {
  const Mesh ball = test::icosphere(3, 30, {0, 0, 0});
  const Atlas atlas = buildAtlas(ball, {});
  const AtlasVertices split = splitAtSeams(ball, atlas);
  ASSERT_EQ(split.triangles.size(), ball.triangles.size());
  ASSERT_EQ(split.uv.size(), split.source.size());
  EXPECT_GT(split.source.size(), ball.positions.size());
  EXPECT_LT(split.source.size(), 2 * ball.positions.size());
  for (std::size_t t = 0; t < ball.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = split.triangles[t][i];
      EXPECT_EQ(split.source[v], ball.triangles[t][i]);
      const glm::vec2 away = split.uv[v] * glm::vec2(atlas.size) - atlas.corners[t][i];
      EXPECT_LT(std::abs(away.x) + std::abs(away.y), 1e-3f);
    }
}

TEST(Atlas, BlocksDoNotTouch) {
  Mesh ball = test::icosphere(2, 20, {0, 0, 0});
  ball.triangles.push_back({0, 1, 1});
  const Atlas atlas = blockAtlas(ball, 0.5, 4096);
  std::vector<int> owners(std::size_t(atlas.size.x) * std::size_t(atlas.size.y), 0);
  for (const Corners& c : atlas.corners) {
    EXPECT_GT(area2(c), 1);
    for (const glm::vec2& p : c) {
      EXPECT_TRUE(p.x > 0 && p.y > 0 && p.x < float(atlas.size.x) && p.y < float(atlas.size.y));
      ++owners[std::size_t(p.y) * std::size_t(atlas.size.x) + std::size_t(p.x)];
    }
  }
  EXPECT_EQ(*std::max_element(owners.begin(), owners.end()), 1);
  EXPECT_EQ(checkAtlas(ball, atlas).overlap, 0);
  EXPECT_LE(blockAtlas(ball, 0.01, 512).size.y, 512);
  EXPECT_THROW(blockAtlas(ball, 0.5, 32), Error);
}

TEST(Atlas, CanBeCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(buildAtlas(test::icosphere(3, 30, {0, 0, 0}), {}, Progress(sink)), Cancelled);
}

// A sheet of 20 mm whose picture is cut in two along its middle: the right half lies to the left of the other.
Mesh pictured() {
  Mesh mesh = sheet(20, [](float x, float y) { return glm::vec3(x, y, 0.1f * x * y); });
  for (const Triangle& t : mesh.triangles) {
    Corners corners;
    const bool isRight = mesh.positions[t[0]].x + mesh.positions[t[1]].x + mesh.positions[t[2]].x > 30;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec2 p(mesh.positions[t[i]]);
      corners[i] = (isRight ? p - glm::vec2(10, 0) : p + glm::vec2(15, 0)) / 40.f;
    }
    mesh.cornerUvs.push_back(corners);
  }
  return mesh;
}

TEST(Atlas, OwnCoordinatesAreUsedAsTheyAre) {
  const Mesh mesh = pictured();
  AtlasOptions options;
  options.texel = 0.2;
  const std::optional<Atlas> atlas = atlasFromCoordinates(mesh, options);
  ASSERT_TRUE(atlas);
  expectWhole(mesh, *atlas);
  EXPECT_EQ(atlas->charts, 2);
  EXPECT_TRUE(atlas->skirts.empty());
  double flat = 0;
  for (const Corners& c : atlas->corners) flat += double(area2(c));
  EXPECT_NEAR(flat * 0.04, surfaceArea(mesh), 0.3 * surfaceArea(mesh));
  const AtlasCheck check = checkAtlas(mesh, *atlas);
  EXPECT_TRUE(check.good());
  EXPECT_NEAR(check.seamLength, 20 * std::sqrt(2.), 0.5);
  EXPECT_EQ(splitAtSeams(mesh, *atlas).source.size(), 21u * 21 + 21);
  options.maxSize = 64;
  EXPECT_LE(atlasFromCoordinates(mesh, options)->size.x, 64);
}

TEST(Atlas, OwnCoordinatesThatAreNoneOrUsedTwiceAreNot) {
  Mesh mesh = pictured();
  for (Corners& corners : mesh.cornerUvs)
    for (glm::vec2& uv : corners) uv.x = uv.x > 0.3f ? uv.x - 0.375f : uv.x;
  EXPECT_FALSE(atlasFromCoordinates(mesh, {}));
  for (Corners& corners : mesh.cornerUvs) corners = {};
  EXPECT_FALSE(atlasFromCoordinates(mesh, {}));
  mesh.cornerUvs[0][0].x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(atlasFromCoordinates(mesh, {}));
  mesh.cornerUvs.pop_back();
  EXPECT_FALSE(atlasFromCoordinates(mesh, {}));
  mesh.cornerUvs.clear();
  EXPECT_FALSE(atlasFromCoordinates(mesh, {}));
}

}  // namespace
}  // namespace sonoskin
