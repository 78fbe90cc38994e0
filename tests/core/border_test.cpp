#include "core/mesh/repair/border.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/mesh/components.h"
#include "core/mesh/facts/mesh_check.h"
#include "core/mesh/repair/clip.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

constexpr float kRadius = 10;

// A sphere and values on it, cut where they are 0 at `inside(direction)`: mm, > 0 inside.
template <class F>
std::vector<float> valuesOf(const Mesh& sphere, const F& inside) {
  std::vector<float> values;
  for (const glm::vec3& p : sphere.positions) values.push_back(std::clamp(inside(p), -0.5f, 0.5f));
  return values;
}

float capMargin(const glm::vec3& p) { return p.z; }

// A strip along the meridian x = 0 that reaches below the equator.
float stripMargin(const glm::vec3& p, float width) {
  return std::min(0.5f * width - std::abs(p.x), std::min(p.y, p.z + 7));
}

Border draw(const Mesh& mesh, const std::vector<float>& values, const BorderOptions& options) {
  return drawBorder(mesh, values, std::vector<std::uint8_t>(values.size(), 0), options);
}

float lowestOf(const Mesh& mesh) {
  float lowest = 1e9f;
  for (const glm::vec3& p : mesh.positions) lowest = std::min(lowest, p.z);
  return lowest;
}

TEST(Border, ATongueIsRemovedAndABroadPartStays) {
  const Mesh sphere = test::icosphere(5, kRadius, {});
  for (const float width : {1.5f, 6.f}) {
    const auto values =
        valuesOf(sphere, [&](const glm::vec3& p) { return std::max(capMargin(p), stripMargin(p, width)); });
    const Mesh with = clipMesh(sphere, draw(sphere, values, {0.5f, 0.3f, 0, 0}).keep);
    const Mesh without = clipMesh(sphere, draw(sphere, values, {0.5f, 0.3f, 3, 0}).keep);
    EXPECT_LT(lowestOf(with), -5);
    if (width < 3)
      EXPECT_GT(lowestOf(without), -1);
    else
      EXPECT_LT(lowestOf(without), -5);
    EXPECT_TRUE(checkMesh(without).manifold());
  }
}

TEST(Border, AStrandBetweenTwoPartsIsCut) {
  const Mesh sphere = test::icosphere(5, kRadius, {});
  const auto values = valuesOf(sphere, [](const glm::vec3& p) {
    return std::max(std::abs(p.z) - 3, std::min(0.7f - std::abs(p.x), p.y));
  });
  EXPECT_EQ(splitPieces(clipMesh(sphere, draw(sphere, values, {0.5f, 0.3f, 0, 0}).keep)).size(), 1u);
  EXPECT_EQ(splitPieces(clipMesh(sphere, draw(sphere, values, {0.5f, 0.3f, 3, 0}).keep)).size(), 2u);
}

// Opening must not eat what is broad: a half sphere keeps its area.
TEST(Border, AStraightBorderStaysWhereItIs) {
  const Mesh sphere = test::icosphere(5, kRadius, {});
  const auto values = valuesOf(sphere, capMargin);
  const double area = 2 * std::numbers::pi * double(kRadius * kRadius);
  EXPECT_NEAR(surfaceArea(clipMesh(sphere, draw(sphere, values, {0.5f, 0.5f, 4, 0}).keep)), area,
              0.01 * area);
}

TEST(Border, SurroundedGapsCloseUpToTheirSizeAndAreNotMeasured) {
  const Mesh sphere = test::icosphere(5, kRadius, {});
  // A gap of 4 mm across at the top, one of 8 mm at the bottom.
  const auto values = valuesOf(sphere, [](const glm::vec3& p) {
    const float across = std::hypot(p.x, p.y);
    return across - (p.z > 0 ? 2.f : 4.f);
  });
  const auto holes = [&](float largest) { return draw(sphere, values, {0.5f, 0.2f, 0, largest}); };
  const Border none = holes(0), small = holes(6), both = holes(10);
  EXPECT_EQ(checkMesh(clipMesh(sphere, none.keep)).euler, 0);
  EXPECT_EQ(checkMesh(clipMesh(sphere, small.keep)).euler, 1);
  EXPECT_EQ(checkMesh(clipMesh(sphere, both.keep)).euler, 2);
  for (std::size_t v = 0; v < sphere.positions.size(); ++v) {
    const glm::vec3 p = sphere.positions[v];
    const float beyond = std::hypot(p.x, p.y) - (p.z > 0 ? 2.f : 4.f);
    if (beyond < -0.7f) {
      ASSERT_EQ(both.measured[v], 0);
    }
    if (beyond > 1.5f) {
      ASSERT_EQ(both.measured[v], 1);
    }
  }
  // Where nothing is known, nothing is closed.
  std::vector<std::uint8_t> isBeyond(values.size(), 0);
  for (std::size_t v = 0; v < values.size(); ++v) isBeyond[v] = sphere.positions[v].z > 9.95f;
  const Border open = drawBorder(sphere, values, isBeyond, {0.5f, 0.2f, 0, 10});
  EXPECT_EQ(checkMesh(clipMesh(sphere, open.keep)).euler, 1);
}

TEST(Border, WhereAllIsSureNothingHappens) {
  const Mesh sphere = test::icosphere(2, kRadius, {});
  const Border border = draw(sphere, std::vector<float>(sphere.positions.size(), 0.5f), {0.5f, 1, 4, 8});
  EXPECT_EQ(border.keep, std::vector<float>(sphere.positions.size(), 0.5f));
  EXPECT_EQ(border.measured, std::vector<float>(sphere.positions.size(), 1));
}

TEST(Border, Cancelled) {
  const Mesh sphere = test::icosphere(3, kRadius, {});
  const std::vector<std::uint8_t> isBeyond(sphere.positions.size(), 0);
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(drawBorder(sphere, valuesOf(sphere, capMargin), isBeyond, {}, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
