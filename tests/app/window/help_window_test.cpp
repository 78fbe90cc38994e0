// The windows that help, by keys and by mouse.
#include "app/workspace/commands.h"
#include "app/workspace/tour.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

bool apart(ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d) {
  return b.x <= c.x || d.x <= a.x || b.y <= c.y || d.y <= a.y;
}

TEST_F(WindowTest, TheTourPointsAtWhatIsThere) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  command("help.tour").run(d.workspace());
  d.frames(3);
  for (const TourCard& card : tourCards()) {
    ASSERT_TRUE(onTour(d.workspace())) << card.title;
    int seen = 0;
    for (const char* name : card.shows) {
      if (!name || !d.knows(name)) continue;
      ++seen;
      EXPECT_TRUE(apart(d.point("tour.card", 0, 0), d.point("tour.card", 1, 1), d.point(name, 0, 0),
                        d.point(name, 1, 1)))
          << name << " is covered";
    }
    EXPECT_GT(seen, 0) << card.title;
    d.press("Return");
  }
  EXPECT_FALSE(onTour(d.workspace()));
  command("help.tour").run(d.workspace());
  d.frames(3);
  d.click("tour.next");
  d.press("shift+Return");
  EXPECT_EQ(d.workspace().help.tour, 0u);
  d.press("2");  // the window goes on below it
  EXPECT_EQ(d.workspace().view.layer, SliceLayer::classified);
  d.press("Escape");
  EXPECT_FALSE(onTour(d.workspace()));
}

TEST_F(WindowTest, TabTakesTheKeyboardIntoTheSidePanel) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  for (const char* keys : {"Tab", "Tab", "Down", "Return"}) d.press(keys);
  EXPECT_EQ(d.workspace().step, Step::classify);
  for (const char* keys : {"shift+Tab", "space"}) d.press(keys);
  EXPECT_EQ(d.workspace().step, Step::region);
  d.screenshot("sonoskin_tab");
  d.session().reconstruct();
  d.press("Escape");
  EXPECT_TRUE(d.session().activity().busy) << "Escape gives the keys back, and ends nothing";
  d.press("Return");
  EXPECT_EQ(d.workspace().step, Step::region);
}

// Questions are answered by keys, too.
TEST_F(WindowTest, QuestionsAreAnsweredByArrowsAndEnter) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  bool done = false;
  d.workspace().question = {"Quitting", [&done] { done = true; }};
  d.frames(3);
  d.press("Right");
  d.press("Return");
  EXPECT_TRUE(done);
  EXPECT_FALSE(d.workspace().question);
}

TEST_F(WindowTest, CommandsAreFoundAndClicked) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.press("ctrl+k");
  d.mouse("type --delay 1 abou");
  d.click("palette.help.about");
  EXPECT_FALSE(d.workspace().help.paletteShown);
  ASSERT_TRUE(d.workspace().aboutShown);
  d.press("Down");
  EXPECT_EQ(d.workspace().help.licence, 1u);
  d.press("Escape");
  EXPECT_FALSE(d.workspace().aboutShown);
  d.press("ctrl+k");
  d.mouse("type --delay 1 beta");
  d.press("Return");
  EXPECT_EQ(d.workspace().step, Step::classify);
  d.mouse("type --delay 1 2.5");
  d.press("Return");
  EXPECT_EQ(d.session().parameters().classification.beta, 2.5) << "the number has not got the keys";
  d.press("ctrl+k");
  d.moveTo({5, 500});
  d.mouse("mousedown 1");
  d.mouse("mouseup 1");
  EXPECT_FALSE(d.workspace().help.paletteShown) << "a click elsewhere closes it";
}

}  // namespace
}  // namespace sonoskin
