#include "app/window/event_feed.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <vector>

#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

using Kind = Event::Kind;

// EventFeedTest: all events have happened before the first of these frames begins, which are slow.
class EventFeedTest : public ImGuiTest {
 protected:
  EventFeedTest() : ImGuiTest({400, 300}) {}

  void frame(const std::optional<Event>& event) {
    feed_.feed(event, now_ += 1, ImGui::GetIO());
    beginFrame();
    ImGui::SetCursorPos({100, 100});
    clicked_ += ImGui::Button("button", {50, 50});
    doubled_ += ImGui::IsMouseDoubleClicked(0);
    ImGui::End();
    ImGui::Render();
  }
  void play(const std::vector<Event>& events) {
    EventQueue queue;
    for (const Event& event : events) queue.add(event);
    while (!queue.empty()) frame(queue.take());
    frame({});
  }
  static Event at(float x, float y, double time) {
    return {.kind = Kind::position, .time = time, .at = {x, y}};
  }
  static Event button(bool down, double time) { return {.kind = Kind::button, .time = time, .down = down}; }
  static Event key(int code, bool down, double time) {
    return {.kind = Kind::key, .time = time, .code = code, .down = down};
  }

  int clicked_ = 0, doubled_ = 0;

 private:
  EventFeed feed_;
  double now_ = 0;
};

TEST_F(EventFeedTest, AClickBetweenTwoFramesIsOne) {
  play({at(120, 120, 1.1), button(true, 1.2), button(false, 1.25), at(10, 10, 1.3)});
  EXPECT_EQ(clicked_, 1);
  EXPECT_EQ(ImGui::GetIO().MousePos.x, 10);
}

TEST_F(EventFeedTest, ClicksAreDoubleByTheirOwnTimes) {
  play({at(120, 120, 1.1), button(true, 1.2), button(false, 1.25), button(true, 1.35), button(false, 1.4)});
  EXPECT_EQ(doubled_, 1);
  play({button(true, 50.0), button(false, 50.1), button(true, 50.8), button(false, 50.9)});
  EXPECT_EQ(doubled_, 1) << "too far apart, however soon the frames follow each other";
}

TEST_F(EventFeedTest, ShortcutsKeepWhatWasHeld) {
  int presses = 0;
  EventQueue queue;
  for (const Event& event : {key(GLFW_KEY_LEFT_CONTROL, true, 1.1), key(GLFW_KEY_V, true, 1.2),
                             key(GLFW_KEY_V, false, 1.25), key(GLFW_KEY_LEFT_CONTROL, false, 1.3)})
    queue.add(event);
  while (!queue.empty()) {
    frame(queue.take());
    presses += ImGui::IsKeyPressed(GLFW_KEY_V) && ImGui::GetIO().KeyCtrl;
  }
  EXPECT_EQ(presses, 1);
  EXPECT_FALSE(ImGui::GetIO().KeyCtrl);
}

TEST_F(EventFeedTest, KeysWithoutANameAreLeftOut) {
  play({key(GLFW_KEY_UNKNOWN, true, 1), key(100000, true, 2)});
  EXPECT_GT(ImGui::GetIO().DeltaTime, 0);
}

// Clocks of the display and the program may differ a little: ImGui's goes on.
TEST_F(EventFeedTest, TimeNeverGoesBack) {
  frame({});
  const double before = ImGui::GetTime();
  frame(key(GLFW_KEY_A, true, 0.5));
  EXPECT_GT(ImGui::GetTime(), before);
}

}  // namespace
}  // namespace sonoskin::ui
