#include "core/base/perpendicular.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

namespace sonoskin {
namespace {

template <int first, int second>
void expectPerpendicular(double limit) {
  for (int a = 0; a <= 20; ++a)
    for (int b = 0; b < 40; ++b) {
      const double polar = glm::pi<double>() * a / 20, azimuth = glm::pi<double>() * b / 20;
      const glm::dvec3 n(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                         std::cos(polar));
      const glm::dvec3 across = perpendicularTo<first, second>(n, limit);
      ASSERT_NEAR(glm::length(across), 1, 1e-12);
      ASSERT_NEAR(glm::dot(across, n), 0, 1e-12);
    }
}

TEST(Perpendicular, IsAUnitVectorAcrossEveryDirection) {
  expectPerpendicular<0, 1>(0.9);
  expectPerpendicular<2, 0>(0.9);
  expectPerpendicular<0, 1>(0.7);
}

TEST(Perpendicular, TakesTheSecondAxisOnlyNearTheFirst) {
  EXPECT_EQ((axisAside<0, 1>(glm::vec3(0, 0, 1))), glm::vec3(1, 0, 0));
  EXPECT_EQ((axisAside<0, 1>(glm::vec3(-1, 0, 0))), glm::vec3(0, 1, 0));
  EXPECT_EQ((axisAside<0, 2>(glm::vec3(0.8f, 0.6f, 0))), glm::vec3(1, 0, 0));
  EXPECT_EQ((axisAside<0, 2>(glm::vec3(0.8f, 0.6f, 0), 0.7)), glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace sonoskin
