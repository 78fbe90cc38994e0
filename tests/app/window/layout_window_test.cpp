#include <array>

#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

// The same slice raw, classified and thinned, one cross-hair in all of them, dividers that are dragged.
TEST_F(WindowTest, ComparesLayersSideBySide) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.press("F3");
  for (const char* pane : {"pane.raw", "pane.classified", "pane.thinned", "pane.space"})
    ASSERT_TRUE(d.knows(pane)) << pane;
  const Image image = d.screenshot("sonoskin_compare");
  const auto bright = [](Colour c) { return c.g > 60; };
  EXPECT_GT(share(image, d, "pane.raw", bright), 0.05);
  EXPECT_GT(share(image, d, "pane.classified", bright), 0.003);
  EXPECT_LT(share(image, d, "pane.thinned", bright), share(image, d, "pane.raw", bright));

  const glm::dvec3 cursor = d.workspace().view.cursor;
  d.workspace().view.cropBox = false;
  d.drag(d.point("pane.classified", 0.5f, 0.5f), d.point("pane.classified", 0.6f, 0.5f));
  EXPECT_GT(d.workspace().view.cursor.x, cursor.x + 2);

  const LayoutState& layout = d.workspace().settings.layout;
  const ImVec2 divider = d.point("divider.across", 0.5f, 0.25f);
  d.drag(divider, {divider.x + 150, divider.y});
  EXPECT_GT(layout.across, 0.55f);
  d.moveTo(d.point("divider.across", 0.5f, 0.25f));
  for (const char* action : {"mousedown 1", "mouseup 1", "mousedown 1", "mouseup 1"}) d.mouse(action);
  EXPECT_EQ(layout.across, 0.5f);
  d.press("F2");
  EXPECT_EQ(layout.layout, Layout::fourUp);
}

// One camera for all: the mouse in one of them turns the others, and each ends with a picture of its own.
TEST_F(WindowTest, RayCastsThatAreComparedTurnTogether) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.press("F4");
  const std::array panes{"pane.raw", "pane.classified", "pane.thinned", "pane.space"};
  for (const char* pane : panes) ASSERT_TRUE(d.knows(pane)) << pane;
  d.frames(40);
  const Image before = d.screenshot("sonoskin_casts");
  const glm::vec3 forward = d.workspace().view.camera.forward;
  d.drag(d.point("pane.classified", 0.4f, 0.5f), d.point("pane.classified", 0.7f, 0.6f));
  EXPECT_LT(glm::dot(d.workspace().view.camera.forward, forward), 0.98f);
  d.frames(40);
  const Image after = d.screenshot("sonoskin_casts_turned");
  for (const char* pane : panes) EXPECT_GT(difference(before, after, d, pane), 0.03) << pane;

  d.doubleClick("pane.thinned");
  EXPECT_EQ(d.workspace().view.maximised, Pane::coronal) << "in the place of that view";
  d.frames(5);
  d.press("Escape");
  EXPECT_FALSE(d.workspace().view.maximised);
  d.press("F2");
  EXPECT_EQ(d.workspace().settings.layout.layout, Layout::fourUp);
}

TEST_F(WindowTest, KeysMarksAndTheCube) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  const Geometry& g = d.session().scan().volume->geometry;
  const auto index = [&] { return g.toIndex(d.workspace().view.cursor); };
  const glm::dvec3 middle = index();
  d.moveTo(d.point("pane.axial", 0.4f, 0.4f));
  d.press("Right");
  EXPECT_NEAR(index().x, middle.x + 1, 1e-6);
  d.press("Prior");
  EXPECT_NEAR(index().z, middle.z + 1, 1e-6) << "Page Up";

  d.press("d");
  d.moveTo(d.point("pane.axial", 0.3f, 0.4f));
  for (const char* action : {"mousedown 1", "mouseup 1"}) d.mouse(action);
  d.moveTo(d.point("pane.axial", 0.6f, 0.4f));
  for (const char* action : {"mousedown 1", "mouseup 1"}) d.mouse(action);
  ASSERT_EQ(d.workspace().view.measures.size(), 1u);
  EXPECT_GT(valueOf(d.workspace().view.measures[0]), 5);
  d.press("ctrl+z");
  EXPECT_TRUE(d.workspace().view.measures.empty());
  d.press("ctrl+shift+z");
  EXPECT_EQ(d.workspace().view.measures.size(), 1u);
  d.press("Escape");
  EXPECT_EQ(d.workspace().view.sliceTool, Tool::crossHair);

  d.drag(d.point("pane.space", 0.5f, 0.5f), d.point("pane.space", 0.65f, 0.6f));
  const glm::vec3 oblique = d.workspace().view.camera.forward;
  EXPECT_LT(glm::dot(oblique, glm::vec3(d.session().beam().axis)), 0.99f);
  d.click("cube.probe");
  EXPECT_GT(glm::dot(d.workspace().view.camera.forward, glm::vec3(d.session().beam().axis)), 0.9999f);
}

}  // namespace
}  // namespace sonoskin
