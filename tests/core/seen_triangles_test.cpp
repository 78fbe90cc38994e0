#include "core/mesh/atlas/seen_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "core/mesh/search/near_triangles.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

constexpr glm::ivec2 kSize{160, 120};

glm::mat4 fromAbove(float distance) {
  return glm::perspective(glm::radians(40.f), 4.f / 3, 0.1f * distance, 10 * distance) *
         glm::lookAt(glm::vec3(0, 0, distance), glm::vec3(0), glm::vec3(0, 1, 0));
}

glm::vec3 middleOf(const Mesh& mesh, const Triangle& t) {
  return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.f;
}

Mesh square(float side) {
  const float h = side / 2;
  Mesh mesh;
  mesh.positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// Whether another triangle than t is met on the way from p to the eye.
bool isHidden(const Mesh& mesh, std::size_t own, const glm::vec3& p, const glm::vec3& eye) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t == own) continue;
    const glm::vec3 &a = mesh.positions[mesh.triangles[t][0]], &b = mesh.positions[mesh.triangles[t][1]],
                    &c = mesh.positions[mesh.triangles[t][2]];
    const glm::mat3 sides(b - a, c - a, p - eye);
    if (std::abs(glm::determinant(sides)) < 1e-6f) continue;
    const glm::vec3 met = glm::inverse(sides) * (p - a);
    if (met.x >= 0 && met.y >= 0 && met.x + met.y <= 1 && met.z > 1e-4f && met.z < 1) return true;
  }
  return false;
}

TEST(SeenTriangles, AreThoseBeforeWhichNothingLies) {
  // A small ball before a large one.
  Mesh mesh = test::icosphere(3, 10, {0, 0, 0});
  const Mesh ball = test::icosphere(2, 4, {3, 0, 16});
  const auto base = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), ball.positions.begin(), ball.positions.end());
  for (const Triangle& t : ball.triangles) mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  const glm::vec3 eye(0, 0, 50);
  const std::vector<std::uint8_t> isSeen = seenTriangles(mesh, fromAbove(50), kSize * 4);
  int seen = 0, hidden = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    int corners = 0;  // near corners and the middle, as seen by a ray
    const glm::vec3 middle = middleOf(mesh, mesh.triangles[t]);
    for (int i = 0; i < 3; ++i)
      corners +=
          !isHidden(mesh, t, glm::mix(mesh.positions[mesh.triangles[t][std::size_t(i)]], middle, 0.2f), eye);
    const bool middleSeen = !isHidden(mesh, t, middle, eye);
    if (middleSeen && corners == 3) {
      EXPECT_TRUE(isSeen[t]) << t;
      ++seen;
    } else if (!middleSeen && corners == 0) {
      hidden += !isSeen[t];
    }
  }
  EXPECT_GT(seen, 300);
  EXPECT_GT(hidden, 500);
}

TEST(SeenTriangles, BothSidesCountAndWhatIsBesideThePictureDoesNot) {
  Mesh mesh = square(2);
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  EXPECT_EQ(seenTriangles(mesh, fromAbove(10), kSize), (std::vector<std::uint8_t>{1, 1}));
  for (glm::vec3& p : mesh.positions) p.x += 100;
  EXPECT_EQ(seenTriangles(mesh, fromAbove(10), kSize), (std::vector<std::uint8_t>{0, 0}));
  // What reaches behind the camera cannot be drawn here, and may be seen.
  mesh.positions[0] = {0, 0, 20};
  const std::vector<std::uint8_t> isSeen = seenTriangles(mesh, fromAbove(10), kSize);
  EXPECT_EQ(std::count(isSeen.begin(), isSeen.end(), 1),
            std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                          [](const Triangle& t) { return std::ranges::count(t, 0u) > 0; }));
}

TEST(SeenTriangles, WithinReachAreAllThatAreNearAndNoneThatAreFar) {
  const Mesh ball = test::icosphere(5, 30, {1, 2, 3});
  std::vector<std::uint8_t> isMarked(ball.triangles.size(), 0);
  isMarked[77] = 1;
  const glm::vec3 from = middleOf(ball, ball.triangles[77]);
  const std::vector<std::uint8_t> isNear = trianglesWithin(ball, isMarked, 8);
  int near = 0, far = 0;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    const float way = glm::distance(middleOf(ball, ball.triangles[t]), from);
    if (way < 8 || way > 16) {
      EXPECT_EQ(bool(isNear[t]), way < 8) << way;
    }
    near += way<8, far += way> 16;
  }
  EXPECT_GT(near, 100);
  EXPECT_GT(far, 1000);
}

TEST(SeenTriangles, MayBeSmallerThanSamples) {
  const Mesh ball = test::icosphere(6, 10, {0, 0, 0});
  const std::vector<std::uint8_t> isSeen = seenTriangles(ball, fromAbove(50), kSize);
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    const glm::vec3 middle = middleOf(ball, ball.triangles[t]);
    // Of a ball of radius 10 seen from 50 mm the part above 2 mm; samples are 0.3 mm apart.
    if (std::abs(middle.z) > 2) {
      EXPECT_EQ(bool(isSeen[t]), middle.z > 0) << middle.z;
    }
  }
}

TEST(SeenTriangles, OfAMeshKeepTheirVerticesAndWhatTheseHold) {
  Mesh ball = test::icosphere(2, 10, {0, 0, 0});
  for (const glm::vec3& p : ball.positions) ball.measured.push_back(p.z > 0 ? 1.f : 0.f);
  const std::vector<std::uint32_t> order{90, 17, 18, 200};
  const Mesh part = selectTriangles(ball, order);
  ASSERT_EQ(part.triangles.size(), order.size());
  EXPECT_LE(part.positions.size(), 12u);
  EXPECT_EQ(part.triangles[0], (Triangle{0, 1, 2}));
  ASSERT_EQ(part.measured.size(), part.positions.size());
  ASSERT_EQ(part.normals.size(), part.positions.size());
  for (std::size_t t = 0; t < order.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = part.triangles[t][i], was = ball.triangles[order[t]][i];
      EXPECT_EQ(part.positions[v], ball.positions[was]);
      EXPECT_EQ(part.normals[v], ball.normals[was]);
      EXPECT_EQ(part.measured[v], ball.measured[was]);
    }
}

}  // namespace
}  // namespace sonoskin
