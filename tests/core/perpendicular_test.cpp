#include "core/base/perpendicular.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

namespace sonoskin {
namespace {

TEST(Perpendicular, IsAUnitVectorAcrossEveryDirection) {
  for (const AxisChoice& choice : {AxisChoice{0, 1}, AxisChoice{2, 0}, AxisChoice{0, 1, 0.7}})
    for (int a = 0; a <= 20; ++a)
      for (int b = 0; b < 40; ++b) {
        const double polar = glm::pi<double>() * a / 20, azimuth = glm::pi<double>() * b / 20;
        const glm::dvec3 n(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                           std::cos(polar));
        const glm::dvec3 across = perpendicularTo(n, choice);
        ASSERT_NEAR(glm::length(across), 1, 1e-12);
        ASSERT_NEAR(glm::dot(across, n), 0, 1e-12);
      }
}

TEST(Perpendicular, TakesTheSecondAxisOnlyNearTheFirst) {
  EXPECT_EQ(axisAside(glm::vec3(0, 0, 1), {0, 1}), glm::vec3(1, 0, 0));
  EXPECT_EQ(axisAside(glm::vec3(-1, 0, 0), {0, 1}), glm::vec3(0, 1, 0));
  EXPECT_EQ(axisAside(glm::vec3(0.8f, 0.6f, 0), {0, 2}), glm::vec3(1, 0, 0));
  EXPECT_EQ(axisAside(glm::vec3(0.8f, 0.6f, 0), {0, 2, 0.7}), glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace sonoskin
