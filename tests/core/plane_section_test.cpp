#include "core/mesh/plane_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

// A plane through a ball at height h meets it in a circle of radius sqrt(r² - h²), whose pieces close.
TEST(PlaneSection, OfABallIsACircle) {
  const double radius = 20;
  const Mesh ball = test::icosphere(5, float(radius), {3, -2, 5});
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
  for (const double height : {0.0, 7.0, -15.0}) {
    const glm::dvec3 point = glm::dvec3(3, -2, 5) + height * normal;
    const double circle = std::sqrt(radius * radius - height * height);
    double length = 0;
    glm::dvec3 ends(0);
    for (const Segment& s : planeSection(ball, point, normal)) {
      length += glm::distance(s[0], s[1]);
      for (const glm::vec3& p : s) {
        EXPECT_NEAR(glm::dot(glm::dvec3(p) - point, normal), 0, 1e-4);
        EXPECT_NEAR(glm::distance(glm::dvec3(p), point), circle, 0.15);
      }
    }
    EXPECT_NEAR(length, 2 * 3.14159265 * circle, 0.01 * circle * 6.3);
  }
  EXPECT_TRUE(planeSection(ball, glm::dvec3(3, -2, 5) + 21.0 * normal, normal).empty());
  EXPECT_TRUE(planeSection({}, {0, 0, 0}, normal).empty());
}

// Corners that lie on the plane itself count once: each end of a piece is the end of another one.
TEST(PlaneSection, ClosesThroughCornersOnThePlane) {
  const Mesh ball = test::icosphere(3, 10, {0, 0, 0});
  std::map<std::array<int, 3>, int> ends;
  for (const Segment& s :
       planeSection(ball, glm::dvec3(ball.positions[ball.positions.size() / 2]), {0, 0, 1}))
    for (const glm::vec3& p : s) {
      const glm::ivec3 key(glm::round(p * 1000.0f));
      ++ends[{key.x, key.y, key.z}];
    }
  ASSERT_FALSE(ends.empty());
  for (const auto& [place, count] : ends) EXPECT_EQ(count % 2, 0) << place[0] << " " << place[1];
}

}  // namespace
}  // namespace sonoskin
