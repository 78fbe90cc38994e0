#include "core/mesh/parts/parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/base/error.h"
#include "core/mesh/components.h"
#include "core/mesh/facts/mesh_check.h"
#include "core/mesh/parts/keep_parts.h"
#include "core/mesh/parts/split_part.h"
#include "core/mesh/parts/watershed.h"
#include "tests/support/expect_error.h"
#include "tests/support/solids.h"

namespace sonoskin {
namespace {

using test::ball;
using test::rod;
using test::solid;

const glm::dvec3 kLeft{-24, 0, 0}, kRight{24, 0, 0};

// Two balls of 14 mm, joined by a rod.
Mesh dumbbell(double rodRadius) {
  return solid(
      [=](const glm::dvec3& x) {
        return std::min({ball(x, kLeft, 14), ball(x, kRight, 14), rod(x, kLeft, kRight, rodRadius)});
      },
      {42, 18, 18}, 0.6);
}

// A head of 30 mm with a ball of `radius` on its surface, on the side of low y.
Mesh headWith(double radius, double out) {
  return solid(
      [=](const glm::dvec3& x) {
        return std::min(ball(x, {0, 8, 0}, 30), ball(x, {0, -22 - out, 0}, radius));
      },
      {36, 48, 36}, 0.8);
}

// Two balls that overlap: the hollow between them lies at x = 0.
Mesh hollowPair() {
  return solid(
      [](const glm::dvec3& x) {
        return std::min(ball(x, {-14, 0, 0}, 16), ball(x, {14, 0, 0}, 16));
      },
      {34, 20, 20}, 0.6);
}

// A plane along x that turns by `angle` at x = 0, hollow for angles > 0; outside is +z.
Mesh fold(float angle) {
  Mesh mesh;
  constexpr int kSide = 60;
  for (int j = 0; j <= kSide; ++j)
    for (int i = 0; i <= kSide; ++i) {
      const float along = 0.5f * float(i - kSide / 2), slope = 0.5f * angle;
      mesh.positions.push_back(
          {along * std::cos(slope), 0.5f * float(j - kSide / 2), std::abs(along) * std::sin(slope)});
    }
  for (std::uint32_t j = 0; j < kSide; ++j)
    for (std::uint32_t i = 0; i < kSide; ++i) {
      const std::uint32_t a = j * (kSide + 1) + i, b = a + 1, c = a + kSide + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

float creaseInMiddle(const Mesh& mesh) {
  const PartGraph graph = makePartGraph(Facets(mesh), 3);
  float crease = 0;
  double area = 0;
  for (std::size_t p = 0; p < graph.size(); ++p) {
    const glm::vec3& c = graph.patches.centre[p];
    if (std::abs(c.x) > 0.8f || std::abs(c.y) > 5) continue;
    crease += graph.area[p] * graph.crease[p];
    area += double(graph.area[p]);
  }
  return crease / float(area);
}

std::size_t largeParts(const SurfaceParts& parts) {
  return std::size_t(
      std::count_if(parts.parts.begin(), parts.parts.end(), [](const Part& p) { return p.area > 100; }));
}

// Every part's triangles hang together.
void expectConnected(const Mesh& mesh, const SurfaceParts& parts) {
  for (std::uint32_t p = 0; p < parts.parts.size(); ++p) {
    Mesh part = mesh;
    part.triangles.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (parts.ofTriangle[t] == p) part.triangles.push_back(mesh.triangles[t]);
    EXPECT_EQ(splitPieces(part).size(), 1u) << p;
  }
}

TEST(PartGraph, CreaseIsTheAngleOfAFold) {
  constexpr float kQuarter = std::numbers::pi_v<float> / 2;
  // The patches' own width beside the line takes a tenth.
  EXPECT_NEAR(creaseInMiddle(fold(kQuarter)), kQuarter, 0.2f);
  EXPECT_NEAR(creaseInMiddle(fold(-kQuarter)), -kQuarter, 0.2f);
  EXPECT_NEAR(creaseInMiddle(fold(0.5f)), 0.5f, 0.07f);
  EXPECT_NEAR(creaseInMiddle(fold(0)), 0, 1e-5f);
}

TEST(PartGraph, NormalsCancelOnStrandsAlone) {
  const PartGraph graph = makePartGraph(Facets(dumbbell(1.5)), 3);
  int onStrand = 0, onBalls = 0;
  for (std::size_t p = 0; p < graph.size(); ++p) {
    if (std::abs(graph.patches.centre[p].x) < 4) {
      EXPECT_LT(graph.flatness[p], 0.35f);
      ++onStrand;
    }
    if (std::abs(graph.patches.centre[p].x) > 24) {
      EXPECT_GT(graph.flatness[p], 0.9f);
      ++onBalls;
    }
  }
  EXPECT_GT(onStrand, 0);
  EXPECT_GT(onBalls, 50);
}

TEST(Watershed, BasinsMeetOnTheCrease) {
  PartGraph line;
  line.crease = {0.1f, 0, 0.5f, 1, 0.4f, 0, 0};  // the last two are equal
  const std::uint32_t count = std::uint32_t(line.crease.size());
  line.patches.centre.resize(count);
  line.patches.start = {0};
  for (std::uint32_t p = 0; p < count; ++p) {
    if (p > 0) line.patches.neighbours.push_back(p - 1);
    if (p + 1 < count) line.patches.neighbours.push_back(p + 1);
    line.patches.start.push_back(std::uint32_t(line.patches.neighbours.size()));
  }
  line.area.assign(count, 1);
  EXPECT_EQ(creaseBasins(line), (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1, 1}));
}

TEST(Parts, CutsAStrand) {
  const Mesh mesh = dumbbell(1.5);
  const SurfaceParts parts = cutParts(mesh);
  ASSERT_EQ(parts.parts.size(), 2u);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const float x = mesh.positions[mesh.triangles[t][0]].x;
    if (std::abs(x) > 12) {
      ASSERT_EQ(x > 0, parts.parts[parts.ofTriangle[t]].centre.x > 0) << x;
    }
  }
  EXPECT_NEAR(parts.parts[0].centre.x * parts.parts[1].centre.x, -24 * 24, 80);
}

TEST(Parts, CutsANeckButNoThickLimb) {
  EXPECT_EQ(cutParts(dumbbell(3)).parts.size(), 2u);
  const Mesh limb = solid(
      [](const glm::dvec3& x) {
        return rod(x, {-30, 0, 0}, {30, 0, 0}, 8);
      },
      {42, 12, 12}, 0.7);
  EXPECT_EQ(cutParts(limb).parts.size(), 1u);
}

TEST(Parts, CutsADeepHollowAlongIt) {
  const Mesh mesh = solid(
      [](const glm::dvec3& x) {
        return std::min(ball(x, {-14, 0, 0}, 16), ball(x, {14, 0, 0}, 16));
      },
      {34, 20, 20}, 0.6);
  const SurfaceParts parts = cutParts(mesh);
  ASSERT_EQ(parts.parts.size(), 2u);
  std::size_t wrong = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::vec3& x = mesh.positions[mesh.triangles[t][0]];
    if (std::abs(x.x) > 2.5f) wrong += (x.x > 0) != (parts.parts[parts.ofTriangle[t]].centre.x > 0);
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(Parts, ANoseIsNoPart) {
  EXPECT_EQ(cutParts(headWith(6, 0)).parts.size(), 1u);
  EXPECT_EQ(cutParts(headWith(3, 2)).parts.size(), 1u);  // too small to be one
  EXPECT_EQ(cutParts(headWith(14, 11)).parts.size(), 2u);
}

TEST(Parts, CoverTheSurfaceLargestFirst) {
  Mesh mesh = joinPieces({dumbbell(1.5), headWith(14, 11)});
  const SurfaceParts parts = cutParts(mesh);
  EXPECT_EQ(largeParts(parts), 4u);
  double area = 0;
  for (std::size_t p = 0; p < parts.parts.size(); ++p) {
    area += parts.parts[p].area;
    if (p > 0) {
      EXPECT_LE(parts.parts[p].area, parts.parts[p - 1].area);
    }
    EXPECT_EQ(partAt(mesh, parts, parts.parts[p].place), p);
  }
  EXPECT_NEAR(area, surfaceArea(mesh), 1e-4 * area);
  expectConnected(mesh, parts);
  EXPECT_NEAR(1 / parts.parts[0].curvature, 30, 3);
  EXPECT_EQ(cutParts(mesh).ofTriangle, parts.ofTriangle);
}

TEST(Parts, NothingAndCancel) {
  EXPECT_TRUE(cutParts({}).parts.empty());
  test::expectError([] { triangleNearest({}, {0, 0, 0}); }, "There is no surface");
  const Mesh mesh = dumbbell(1.5);
  ProgressSink sink;
  sink.report = [&](double fraction) { sink.cancel = fraction > 0.5; };
  EXPECT_THROW(cutParts(mesh, Progress(sink)), Cancelled);
}

std::vector<PartVerdict> keepOnly(const SurfaceParts& parts, std::uint32_t which) {
  std::vector<PartVerdict> verdicts(parts.parts.size());
  verdicts[which].kept = true;
  return verdicts;
}

TEST(KeepParts, CutsAlongASmoothLine) {
  const Mesh mesh = hollowPair();
  const SurfaceParts parts = cutParts(mesh);
  const std::uint32_t left = partAt(mesh, parts, {-30, 0, 0});
  const Mesh kept = keepParts(mesh, parts, keepOnly(parts, left));
  EXPECT_NEAR(surfaceArea(kept), parts.parts[left].area, 0.03 * parts.parts[left].area);
  EXPECT_EQ(kept.normals.size(), kept.positions.size());
  const std::vector<std::uint32_t> opposite = oppositeHalfEdges(kept.triangles, kept.positions.size());
  const auto loops = borderLoops(kept.triangles, opposite);
  ASSERT_EQ(loops.size(), 1u);
  // Its length is near the least around what it cuts, within a fifth: teeth would double it.
  float length = 0, mean = 0, radius = 0;
  for (const std::uint32_t h : loops[0]) {
    const glm::vec3 &a = kept.positions[originOf(kept.triangles, h)],
                    &b = kept.positions[originOf(kept.triangles, nextHalfEdge(h))];
    length += glm::distance(a, b);
    mean += a.x;
    radius += std::hypot(a.y, a.z);
  }
  mean /= float(loops[0].size());
  radius /= float(loops[0].size());
  EXPECT_LT(length, 1.2f * 2 * std::numbers::pi_v<float> * radius);
  for (const std::uint32_t h : loops[0])
    EXPECT_NEAR(kept.positions[originOf(kept.triangles, h)].x, mean, 1.0f);
}

TEST(KeepParts, AllAndNothing) {
  const Mesh mesh = dumbbell(1.5);
  const SurfaceParts parts = cutParts(mesh);
  std::vector<PartVerdict> verdicts(parts.parts.size());
  EXPECT_TRUE(keepParts(mesh, parts, verdicts).empty());
  for (PartVerdict& v : verdicts) v.kept = true;
  EXPECT_EQ(keepParts(mesh, parts, verdicts).triangles, mesh.triangles);
}

TEST(SplitPart, HalvesABallAlongTheStroke) {
  const Mesh mesh = solid([](const glm::dvec3& x) { return ball(x, {0, 0, 0}, 20); }, {24, 24, 24}, 0.7);
  SurfaceParts parts = cutParts(mesh);
  ASSERT_EQ(parts.parts.size(), 1u);
  ASSERT_TRUE(splitPart(mesh, parts, {{19, -6, 0}, {-19, -6, 0}, {0, -100, 0}}));
  ASSERT_EQ(parts.parts.size(), 2u);
  EXPECT_NEAR(parts.parts[0].area, parts.parts[1].area, 0.02 * parts.parts[0].area);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::vec3& x = mesh.positions[mesh.triangles[t][0]];
    if (std::abs(x.z) > 1) {
      EXPECT_EQ(x.z > 0, parts.parts[parts.ofTriangle[t]].centre.z > 0);
    }
  }
  expectConnected(mesh, parts);
}

// A stroke that ends in the middle: the rest goes with the nearer side, and both sides stay whole.
TEST(SplitPart, GoesOnWhereTheStrokeEnds) {
  const Mesh mesh = solid(
      [](const glm::dvec3& x) {
        return rod(x, {-30, 0, 0}, {30, 0, 0}, 8);
      },
      {42, 12, 12}, 0.7);
  SurfaceParts parts = cutParts(mesh);
  ASSERT_TRUE(splitPart(mesh, parts, {{10, -6.9f, 4}, {10, -6.9f, -4}, {10, -80, 0}}));
  ASSERT_EQ(parts.parts.size(), 2u);
  EXPECT_NEAR(parts.parts[0].area / parts.parts[1].area, 48.0 / 28.0, 0.25);
  expectConnected(mesh, parts);
}

TEST(SplitPart, RefusesWhatCutsNothing) {
  const Mesh mesh = dumbbell(1.5);
  SurfaceParts parts = cutParts(mesh);
  const auto before = parts.ofTriangle;
  EXPECT_FALSE(splitPart(mesh, parts, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}));
  EXPECT_FALSE(splitPart(mesh, parts, {{-38, 0, 0}, {-40, 0, 0}, {-50, 0, 0}}));       // one line
  EXPECT_FALSE(splitPart(mesh, parts, {{-38, 0, 0}, {-38, 60, 60}, {-38, -70, 40}}));  // beside the ball
  EXPECT_EQ(parts.ofTriangle, before);
}

}  // namespace
}  // namespace sonoskin
