// Menus by keyboard, Escape, themes and scales in the real window.
#include "app/widgets/open_lists.h"
#include "app/widgets/theme.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

TEST_F(WindowTest, MenusOpenByKeysAndEscapeClosesThemAlone) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.session().reconstruct();
  d.press("alt+v");
  EXPECT_TRUE(ui::listIsOpen());
  ASSERT_TRUE(d.session().activity().busy);
  d.press("Escape");
  EXPECT_FALSE(ui::listIsOpen());
  EXPECT_NE(d.session().state(), DocumentState::stopped) << "the work was cancelled instead";
  ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));

  // The third entry of a menu, by arrows and Enter; letters meanwhile are no commands.
  d.press("F10");
  ASSERT_TRUE(ui::listIsOpen());
  const SliceLayer layer = d.workspace().view.layer;
  d.press("2");
  EXPECT_EQ(d.workspace().view.layer, layer);
  for (int i = 0; i < 3; ++i) d.mouse("key Right");
  d.screenshot("sonoskin_menu");
  for (const char* key : {"Down", "Down", "Return"}) d.mouse(std::string("key ") + key);
  EXPECT_EQ(d.workspace().step, Step::classify);
  EXPECT_FALSE(ui::listIsOpen());

  d.press("h");
  ASSERT_TRUE(d.workspace().keysShown);
  d.press("Escape");
  EXPECT_FALSE(d.workspace().keysShown);
}

// The mouse that rests on the line of an inner menu does not open it again.
TEST_F(WindowTest, EscapeClosesAnInnerMenuBelowTheMouse) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.press("alt+v");
  ASSERT_TRUE(ui::listIsOpen());
  d.moveTo(d.point("submenu.Layout"));
  d.frames(30);
  ASSERT_EQ(ui::openLists(), 2) << "it has opened by itself";
  d.press("Escape");
  d.frames(30);
  EXPECT_FALSE(ui::listIsOpen());
  d.press("ctrl+k");
  EXPECT_TRUE(d.workspace().help.paletteShown);
  d.press("Escape");
}

TEST_F(WindowTest, ThemeAndScaleCountAtOnce) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  const auto grey = [&](const char* name) {
    const ImVec2 at = d.point("step.export", 0.55f);
    return pixel(d.screenshot(name), int(at.x), int(at.y)).g;
  };
  EXPECT_LT(grey("sonoskin_dark"), 60);
  d.workspace().settings.appearance = Appearance::light;
  EXPECT_GT(grey("sonoskin_light"), 200);
  const float width = ui::unit();
  d.press("ctrl+equal");
  d.frames(3);
  EXPECT_FLOAT_EQ(ui::unit(), 1.25f * width);
  d.screenshot("sonoskin_larger");
  d.press("ctrl+0");
  d.frames(3);
  EXPECT_FLOAT_EQ(ui::unit(), width);
}

// Whatever failed leaves the window by itself, and lies over no view meanwhile.
TEST_F(WindowTest, MessagesOfFailuresLieOverNoViewAndLeave) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.workspace().toasts.add("The file could not be read, for it is not there at all, nor anywhere near.",
                           true);
  d.frames(4);
  EXPECT_LT(d.point("toast0", 1).x, d.point("pane.axial", 0).x);
  EXPECT_LT(d.point("toast0", 1, 1).y, d.point("surface.reconstruct", 0, 0).y);
  EXPECT_GT(d.workspace().toasts.list.front().until, 0);
  d.workspace().toasts.list.front().until = ImGui::GetTime();
  d.frames(2);
  EXPECT_TRUE(d.workspace().toasts.list.empty());
  EXPECT_EQ(d.workspace().toasts.log.unseen, 1u) << "the log's button counts it";
}

}  // namespace
}  // namespace sonoskin
