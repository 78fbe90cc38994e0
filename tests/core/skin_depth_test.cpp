#include "core/surface/skin_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sonoskin {
namespace {

// Points all over a ball, evenly, normals outward.
SurfacePoints ball(float radius, int count = 4000) {
  SurfacePoints points;
  for (int n = 0; n < count; ++n) {
    const float z = 1 - (2 * float(n) + 1) / float(count), angle = float(n) * 2.39996f;
    const float r = std::sqrt(1 - z * z);
    const glm::vec3 out(r * std::cos(angle), r * std::sin(angle), z);
    points.positions.push_back(radius * out);
    points.normals.push_back(out);
    points.confidence.push_back(1);
  }
  return points;
}

TEST(MoveOntoSkin, MovesABallsPointsToASmallerBall) {
  SurfacePoints points = ball(12);
  moveOntoSkin(points, 0.8f);
  for (const glm::vec3& p : points.positions) EXPECT_NEAR(glm::length(p), 11.2f, 0.02f);
}

// A rod 2 mm thick, such as a premature finger: at most a quarter of its thickness from each side.
TEST(MoveOntoSkin, LeavesThinBodiesWhole) {
  SurfacePoints points;
  for (int i = 0; i < 80; ++i)
    for (int j = 0; j < 24; ++j) {
      const float angle = 2 * std::numbers::pi_v<float> * float(j) / 24;
      const glm::vec3 out(std::cos(angle), std::sin(angle), 0);
      points.positions.push_back(out + glm::vec3(0, 0, 0.25f * float(i)));
      points.normals.push_back(out);
      points.confidence.push_back(1);
    }
  moveOntoSkin(points, 1);
  float least = 1, most = 0;
  for (const glm::vec3& p : points.positions) {
    least = std::min(least, glm::length(glm::vec2(p)));
    most = std::max(most, glm::length(glm::vec2(p)));
  }
  EXPECT_GE(least, 0.49f);
  EXPECT_LE(most, 0.67f);
}

// Single normals that are wrong move no point out of its row.
TEST(MoveOntoSkin, AveragesTheNormals) {
  SurfacePoints points;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j) {
      points.positions.push_back({0.3f * float(i), 0.3f * float(j), 0});
      points.normals.push_back(glm::normalize(glm::vec3(0.6f * std::sin(7.f * float(i + 3 * j)), 0, 1)));
      points.confidence.push_back(1);
    }
  const std::vector<glm::vec3> before = points.positions;
  moveOntoSkin(points, 1);
  for (int i = 10; i < 50; ++i)
    for (int j = 10; j < 50; ++j) {
      const std::size_t p = std::size_t(60 * i + j);
      EXPECT_NEAR(points.positions[p].z, -1, 0.02f);
      EXPECT_NEAR(points.positions[p].x, before[p].x, 0.15f);
    }
}

TEST(MoveOntoSkin, LeavesPointsAloneWithoutDepth) {
  SurfacePoints points = ball(5), none;
  const std::vector<glm::vec3> before = points.positions;
  moveOntoSkin(points, 0);
  EXPECT_EQ(points.positions, before);
  moveOntoSkin(none, 1);
}

}  // namespace
}  // namespace sonoskin
