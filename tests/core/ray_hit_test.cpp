#include "core/mesh/search/ray_hit.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

TEST(FirstHit, MeetsASphereWhereTheEquationSays) {
  const glm::vec3 centre{3, -4, 5};
  const float radius = 10;
  const Mesh sphere = test::icosphere(5, radius, centre);
  std::mt19937 engine(3);
  std::uniform_real_distribution<float> number(-1, 1);
  int hits = 0;
  for (int n = 0; n < 60; ++n) {
    const glm::vec3 origin =
        centre + 30.f * glm::normalize(glm::vec3(number(engine), number(engine), number(engine)));
    const glm::vec3 target = centre + 13.f * glm::vec3(number(engine), number(engine), number(engine));
    const glm::vec3 direction = glm::normalize(target - origin);
    const float along = glm::dot(centre - origin, direction);
    const float off2 = glm::dot(centre - origin, centre - origin) - along * along;
    if (std::abs(off2 - radius * radius) < 2) continue;  // the rim of many facets
    const auto hit = firstHit(sphere, origin, direction);
    ASSERT_EQ(hit.has_value(), off2 < radius * radius);
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(*hit, along - std::sqrt(radius * radius - off2), 0.05f);
  }
  EXPECT_GT(hits, 15);
}

TEST(FirstHit, SeesBothSidesAndNothingBehind) {
  const Mesh sphere = test::icosphere(3, 10, {});
  EXPECT_NEAR(firstHit(sphere, {0, 0, 0}, {0, 0, 1}).value(), 10, 0.1) << "from inside";
  EXPECT_FALSE(firstHit(sphere, {0, 0, 20}, {0, 0, 1}));
  EXPECT_FALSE(firstHit(Mesh{}, {0, 0, 20}, {0, 0, -1}));
}

}  // namespace
}  // namespace sonoskin
