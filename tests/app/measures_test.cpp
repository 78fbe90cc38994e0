#include "app/document/measures.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

TEST(Measures, HaveMarksEnoughOrNot) {
  Measure angle{MeasureKind::angle, {{0, 0, 0}, {1, 0, 0}}};
  EXPECT_FALSE(isComplete(angle));
  EXPECT_EQ(measureText(angle), "");
  angle.marks.push_back({1, 1, 0});
  EXPECT_TRUE(isComplete(angle) && isFull(angle));
  angle.marks.push_back({1, 1, 1});
  EXPECT_FALSE(isComplete(angle)) << "an angle has three marks, and no more";
  EXPECT_TRUE(isFull(angle));
  const Measure area{MeasureKind::area, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}};
  EXPECT_TRUE(isComplete(area));
  EXPECT_FALSE(isFull(area)) << "it takes more marks";
}

TEST(Measures, DistancesAreLengthsInMillimetres) {
  EXPECT_DOUBLE_EQ(valueOf({MeasureKind::distance, {{1, 2, 3}, {4, 6, 15}}}), 13);
  EXPECT_EQ(measureText({MeasureKind::distance, {{0, 0, 0}, {0, 3, 4}}}), "5.0 mm");
}

TEST(Measures, AnglesAreAtTheSecondMark) {
  const auto angle = [](double degrees) {
    const double a = glm::radians(degrees);
    return valueOf({MeasureKind::angle, {{5, 0, 0}, {2, 0, 0}, {2 + 7 * std::cos(a), 0, 7 * std::sin(a)}}});
  };
  for (const double degrees : {0.0, 1e-4, 30.0, 90.0, 135.0, 179.9999, 180.0})
    EXPECT_NEAR(angle(degrees), degrees, 1e-9);
  EXPECT_EQ(valueOf({MeasureKind::angle, {{1, 0, 0}, {1, 0, 0}, {2, 0, 0}}}), 0);
}

// A star-shaped border, and a concave one, in an oblique plane.
TEST(Measures, AreasAreThoseOfPolygonsInAnyPlane) {
  const glm::dvec3 u = glm::normalize(glm::dvec3(1, 2, -1)), v = glm::normalize(glm::cross(u, {0, 0, 1}));
  const auto at = [&](double x, double y) { return glm::dvec3(10, -4, 3) + x * u + y * v; };
  EXPECT_NEAR(valueOf({MeasureKind::area, {at(0, 0), at(4, 0), at(4, 3), at(0, 3)}}), 12, 1e-12);
  const Measure angled{MeasureKind::area, {at(0, 0), at(4, 0), at(4, 1), at(1, 1), at(1, 5), at(0, 5)}};
  EXPECT_NEAR(valueOf(angled), 8, 1e-12);
  EXPECT_EQ(measureText(angled), "8.0 mm²");
}

}  // namespace
}  // namespace sonoskin
