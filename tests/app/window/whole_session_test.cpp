// A session as a person has it, with the mouse and the keys of the display, from the first file to the same picture again: at
// the speed of the machine, and with frames of 0.3 s, where a whole gesture falls between two of them.
#include <thread>

#include "tests/app/session_script.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

using test::Act;

// What xdotool is told.
std::string command(const Act& act) {
  switch (act.kind) {
    case Act::Kind::move:
      return "mousemove " + std::to_string(int(act.at.x)) + " " + std::to_string(int(act.at.y)) + " ";
    case Act::Kind::press:
      return "mousedown 1 ";
    case Act::Kind::release:
      return "mouseup 1 ";
    case Act::Kind::key:
      return "key " + act.text + " ";
    case Act::Kind::type:
      return "type --delay 1 " + act.text;  // takes all that follows
  }
  return {};
}

// MousePlayer: has the display's mouse and keys.
//   slow  each frame takes 0.3 s, and what a hand does happens during one of them
class MousePlayer : public test::Player {
 public:
  explicit MousePlayer(bool slow) : slow_(slow) {}

  Application& application() override { return driver_->loop.application(); }
  const ui::WidgetRects& rects() const override { return driver_->rects(); }
  void frames(int count) override { driver_->frames(count); }
  Image picture() override { return driver_->screenshot("sonoskin_session"); }
  void restart() override {
    driver_.reset();
    driver_ = std::make_unique<Driver>(test::scriptParameters());
  }
  void hand(const std::vector<Act>& acts) override {
    std::string commands = "xdotool ";
    for (const Act& act : acts) commands += command(act);
    if (slow_)
      duringAFrame(commands);
    else
      ASSERT_EQ(std::system(commands.c_str()), 0) << commands;
    frames(2);
    driver_->loop.atFrame = {};
  }

 private:
  void duringAFrame(const std::string& commands) {
    const auto slowly = [] { std::this_thread::sleep_for(std::chrono::milliseconds(300)); };
    int status = -1;
    driver_->loop.atFrame = [&, shown = 0]() mutable {
      if (shown++ == 0) status = std::system(commands.c_str());
      slowly();
    };
    frames(1);
    driver_->loop.atFrame = slowly;
    ASSERT_EQ(status, 0) << commands;
  }

  std::unique_ptr<Driver> driver_ = std::make_unique<Driver>(test::scriptParameters());
  bool slow_;
};

class WholeSessionTest : public testing::Test {
 protected:
  void SetUp() override {
    setenv("XDG_CONFIG_HOME", (folder_.path() / "settings").c_str(), 1);
    setenv("XDG_STATE_HOME", (folder_.path() / "state").c_str(), 1);
  }
  void play(bool slow) {
    MousePlayer player(slow);
    player.folder = folder_.path();
    test::beginScript(player);
    for (const test::ScriptPiece& piece : test::sessionScript()) {
      SCOPED_TRACE(piece.name);
      ASSERT_NO_FATAL_FAILURE(piece.play(player));
    }
    test::quitAndReopen(player);
  }

 private:
  const test::TempFolder folder_;
};

TEST_F(WholeSessionTest, AtTheSpeedOfTheMachine) { play(false); }

TEST_F(WholeSessionTest, WithFramesOfThreeTenthsOfASecond) { play(true); }

}  // namespace
}  // namespace sonoskin
