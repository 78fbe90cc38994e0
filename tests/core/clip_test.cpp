#include "core/mesh/repair/clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "core/mesh/facts/mesh_check.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

std::vector<float> heights(const Mesh& mesh, float above) {
  std::vector<float> values;
  for (const glm::vec3& p : mesh.positions) values.push_back(p.z - above);
  return values;
}

// The length of the edges that belong to one triangle.
double borderLength(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  double length = 0;
  for (const auto& [edge, count] : uses)
    if (count == 1) length += double(glm::distance(mesh.positions[edge.first], mesh.positions[edge.second]));
  return length;
}

TEST(ClipMesh, CutsACapOffASphere) {
  constexpr double kRadius = 10, kHeight = 3;
  const Mesh sphere = test::icosphere(5, float(kRadius), glm::vec3(0));
  const Mesh cap = clipMesh(sphere, heights(sphere, float(kHeight)));
  // Archimedes: the cap's area is that of the band around it on the cylinder.
  EXPECT_NEAR(surfaceArea(cap), 2 * std::numbers::pi * kRadius * (kRadius - kHeight), 0.5);
  EXPECT_NEAR(borderLength(cap), 2 * std::numbers::pi * std::sqrt(kRadius * kRadius - kHeight * kHeight),
              0.5);
  const MeshCheck check = checkMesh(cap);
  EXPECT_TRUE(check.manifold() && check.oriented());
  EXPECT_EQ(check.euler, 1);  // a disc
  EXPECT_EQ(check.degenerateTriangles, 0u);
  EXPECT_EQ(check.usedVertices, cap.positions.size());
  ASSERT_EQ(cap.normals.size(), cap.positions.size());
  for (std::size_t v = 0; v < cap.positions.size(); ++v) {
    ASSERT_GT(cap.positions[v].z, kHeight - 0.1);
    ASSERT_GT(glm::dot(cap.normals[v], glm::normalize(cap.positions[v])), 0.999f);
  }
}

TEST(ClipMesh, LabelsAreThoseOfTheVerticesThatStay) {
  Mesh sphere = test::icosphere(4, 10, glm::vec3(0));
  for (const glm::vec3& p : sphere.positions) sphere.labels.push_back(p.z > 3 ? 2 : 7);
  const Mesh cap = clipMesh(sphere, heights(sphere, 3));
  EXPECT_EQ(cap.labels, std::vector<std::uint8_t>(cap.positions.size(), 2));
}

TEST(ClipMesh, KeepsAllOrNothing) {
  const Mesh sphere = test::icosphere(2, 10, glm::vec3(0));
  EXPECT_EQ(clipMesh(sphere, heights(sphere, -11)).triangles, sphere.triangles);
  EXPECT_TRUE(clipMesh(sphere, heights(sphere, 11)).empty());
}

TEST(SmoothAlong, CalmsTheNoiseOfABorderAndLeavesWhatIsFarFromIt) {
  const Mesh sphere = test::icosphere(5, 10, glm::vec3(0));
  std::vector<float> values = heights(sphere, 3);
  for (std::size_t v = 0; v < values.size(); ++v) values[v] += 0.4f * std::sin(float(v) * 12.9898f);
  const std::vector<float> smoothed = smoothAlong(VertexRings(sphere), values, 2, 10);
  const double rough = borderLength(clipMesh(sphere, values)),
               smooth = borderLength(clipMesh(sphere, smoothed));
  const double circle = 2 * std::numbers::pi * std::sqrt(100.0 - 9);
  EXPECT_GT(rough, 1.2 * circle);
  EXPECT_NEAR(smooth, circle, 0.03 * circle);
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (std::abs(values[v]) >= 2) {
      ASSERT_EQ(smoothed[v], values[v]);
    }
  }
}

}  // namespace
}  // namespace sonoskin
