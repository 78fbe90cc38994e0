#include "core/mesh/print/print_solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/components.h"
#include "core/mesh/facts/mesh_facts.h"
#include "core/mesh/half_edges.h"
#include "core/mesh/search/triangle_tree.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

constexpr double kPi = std::numbers::pi;

// z = height(x, y) over a square of 2 * half mm, n x n squares, seen from +z.
template <class Height>
Mesh sheet(float half, int n, const Height& height) {
  Mesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const float x = half * (2 * float(i) / float(n) - 1), y = half * (2 * float(j) / float(n) - 1);
      mesh.positions.push_back({x, y, height(x, y)});
    }
  const auto w = std::uint32_t(n + 1);
  for (std::uint32_t j = 0; j + 1 < w; ++j)
    for (std::uint32_t i = 0; i + 1 < w; ++i) {
      const std::uint32_t a = j * w + i;
      mesh.triangles.insert(mesh.triangles.end(), {{a, a + 1, a + w + 1}, {a, a + w + 1, a + w}});
    }
  return mesh;
}

Mesh hemisphere(float radius) {
  Mesh mesh = test::icosphere(5, radius, {});
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.positions[v].z < -1e-4f; });
  });
  compactVertices(mesh);
  return mesh;
}

// How far the surface is from the solid, at most, without a strip at its border.
double frontError(const Mesh& surface, const Mesh& solid, float strip) {
  const TriangleTree tree(solid);
  const auto opposite = oppositeHalfEdges(surface.triangles, surface.positions.size());
  std::vector<glm::vec3> border;
  for (const auto& loop : borderLoops(surface.triangles, opposite))
    for (const auto h : loop) border.push_back(surface.positions[originOf(surface.triangles, h)]);
  double worst = 0;
  for (const glm::vec3& p : surface.positions) {
    const bool isNear = std::any_of(border.begin(), border.end(),
                                    [&](const glm::vec3& b) { return glm::distance(b, p) < strip; });
    if (!isNear) worst = std::max(worst, std::sqrt(double(tree.nearest(p).squaredDistance)));
  }
  return worst;
}

TEST(PrintSolid, ShellOfAHemisphere) {
  // 2/3 pi (20³ - 17³)
  const Mesh surface = hemisphere(20);
  const Mesh shell = makePrintSolid(surface, {PrintForm::shell, 3, 1});
  const MeshFacts facts = measureMesh(shell);
  EXPECT_TRUE(facts.printable());
  EXPECT_EQ(facts.pieces, 1u);
  EXPECT_EQ(facts.check.euler, 2);
  const double rim =
      kPi * (20.0 * 20 - 17 * 17);  // the border's zigzag: the mesh ends within 0.2 mm of z = 0
  EXPECT_NEAR(facts.volume, 2 * kPi / 3 * (8000 - 4913), 0.02 * 6465 + 0.2 * rim * 0);
  EXPECT_LT(frontError(surface, shell, 1.f), 0.02);
  // Where measured, the wall is 3 mm thick.
  int onBack = 0;
  for (const glm::vec3& p : shell.positions) {
    if (p.z <= 3 || glm::length(p) >= 18.5f) continue;
    EXPECT_NEAR(glm::length(p), 17, 0.1);
    ++onBack;
  }
  EXPECT_GT(onBack, 100);
}

TEST(PrintSolid, BlockOfASquareIsAPrism) {
  const Mesh surface = sheet(10, 40, [](float, float) { return 5.f; });
  const Mesh block = makePrintSolid(surface, {PrintForm::block, 4, 1});
  const MeshFacts facts = measureMesh(block);
  EXPECT_TRUE(facts.printable());
  EXPECT_EQ(facts.check.euler, 2);
  EXPECT_NEAR(facts.volume, 20 * 20 * 4, 0.01 * 1600);
  EXPECT_NEAR(facts.size.x, 20, 0.2);
  EXPECT_NEAR(facts.size.z, 4, 0.02);
  EXPECT_LT(frontError(surface, block, 0.2f), 0.01);
}

TEST(PrintSolid, BlockOfAReliefHasAFlatBackAndTheVolumeAboveIt) {
  const auto height = [](float x, float y) { return 3 * std::cos(0.3f * x) * std::cos(0.25f * y); };
  const Mesh surface = sheet(12, 96, height);
  const Mesh block = makePrintSolid(surface, {PrintForm::block, 3, 1});
  double low = 1e9, above = 0;
  for (const glm::vec3& p : surface.positions) low = std::min(low, double(p.z));
  for (const glm::vec3& p : surface.positions) above += (double(p.z) - low + 3) * 24 * 24 / 97 / 97;
  const MeshFacts facts = measureMesh(block);
  EXPECT_TRUE(facts.printable());
  EXPECT_NEAR(facts.volume, above, 0.02 * above);
  EXPECT_NEAR(boundingBox(block.positions).min.z, low - 3, 0.05);
  EXPECT_LT(frontError(surface, block, 0.5f), 0.03);
}

// A sheet that folds over itself like a nose seen from below, and waves too tight for an offset of 3 mm.
TEST(PrintSolid, FoldsAndTightWavesCrossNothing) {
  Mesh folded = sheet(12, 120, [](float x, float y) { return 2 * std::sin(1.5f * x) * std::cos(1.2f * y); });
  for (glm::vec3& p : folded.positions)
    p.x += 0.9f * p.z * std::exp(-0.02f * p.y * p.y) + 0.6f * std::sin(p.z);
  for (const PrintForm form : {PrintForm::shell, PrintForm::block}) {
    const Mesh solid = makePrintSolid(folded, {form, 3, 1});
    const MeshFacts facts = measureMesh(solid);
    EXPECT_TRUE(facts.check.closed() && facts.check.manifold() && facts.check.oriented());
    EXPECT_EQ(facts.selfIntersections, 0u);
    EXPECT_EQ(facts.check.degenerateTriangles, 0u);
    EXPECT_GT(facts.volume, 24 * 24 * 2.0);
    EXPECT_EQ(facts.pieces, 1u);
  }
}

TEST(PrintSolid, HolesAreClosedAndScaleIsApplied) {
  Mesh surface = sheet(10, 40, [](float, float) { return 0.f; });
  std::erase_if(surface.triangles,
                [&](const Triangle& t) { return glm::length(surface.positions[t[0]]) < 3; });
  compactVertices(surface);
  const MeshFacts facts = measureMesh(makePrintSolid(surface, {PrintForm::shell, 3, 2}));
  EXPECT_EQ(facts.check.euler, 2);  // no tunnel
  EXPECT_NEAR(facts.volume, 8 * 20 * 20 * 3, 0.02 * 8 * 1200);
  EXPECT_NEAR(facts.size.x, 40, 0.2);
}

TEST(PrintSolid, AClosedSurfaceIsASolidAlready) {
  const MeshFacts facts = measureMesh(makePrintSolid(test::icosphere(5, 10, {}), {PrintForm::shell, 2, 1}));
  EXPECT_TRUE(facts.printable());
  EXPECT_NEAR(facts.volume, 4 * kPi / 3 * 1000, 0.01 * 4189);
}

TEST(PrintSolid, SameOnAnyNumberOfThreads) {
  const Mesh surface = sheet(5, 20, [](float x, float) { return 0.1f * x * x; });
  setThreadCount(1);
  const Mesh one = makePrintSolid(surface, {PrintForm::block, 2, 1});
  setThreadCount(2);
  const Mesh two = makePrintSolid(surface, {PrintForm::block, 2, 1});
  setThreadCount(0);
  EXPECT_EQ(one.positions, two.positions);
  EXPECT_EQ(one.triangles, two.triangles);
}

TEST(PrintSolid, BadInputAndCancel) {
  const Mesh surface = sheet(100, 40, [](float, float) { return 0.f; });
  test::expectError([&] { makePrintSolid(surface, {}); }, "print.form");
  test::expectError([&] { makePrintSolid({}, {PrintForm::shell, 3, 1}); }, "no surface");
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(makePrintSolid(surface, {PrintForm::shell, 3, 1}, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
