#include <cmath>

#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

// The oblique plane is turned by the end of its line in another slice, and by its numbers.
TEST_F(WindowTest, TurnsTheObliquePlane) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.press("F5");
  d.frames(5);
  for (const char* pane : {"pane.oblique", "pane.space", "pane.axial", "pane.coronal", "pane.sagittal"})
    ASSERT_TRUE(d.knows(pane)) << pane;
  const ViewState& view = d.workspace().view;
  const glm::dvec3 normal = view.oblique.directions.normal(), cursor = view.cursor;
  const Image before = d.screenshot("sonoskin_oblique");
  const ImVec2 end = d.point("oblique.sagittal.0");
  d.drag(end, {end.x + 60, end.y + 20});
  const double degrees = glm::degrees(std::acos(glm::dot(view.oblique.directions.normal(), normal)));
  EXPECT_GT(degrees, 10);
  EXPECT_LT(degrees, 80);
  EXPECT_EQ(view.cursor, cursor);
  const Image after = d.screenshot("sonoskin_oblique_turned");
  EXPECT_GT(difference(before, after, d, "pane.oblique"), 0.03);

  d.click("oblique.reset");
  EXPECT_NEAR(glm::dot(view.oblique.directions.normal(), normal), std::cos(glm::radians(30.0)), 1e-6);
  d.doubleClick("oblique.turn");
  d.mouse("key ctrl+a");
  d.mouse("type 25");
  d.press("Return");
  EXPECT_NEAR(anglesOf(view.oblique.directions,
                       directionsOf(d.session().scan().volume->geometry, view.planes[Plane::axial]))
                  .turn,
              25, 1e-3);
  d.press("F2");
  EXPECT_EQ(d.workspace().settings.layout.layout, Layout::fourUp);
}

}  // namespace
}  // namespace sonoskin
