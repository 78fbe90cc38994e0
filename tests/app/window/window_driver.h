#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/widgets/widget_rects.h"
#include "app/window/window_loop.h"
#include "core/base/timer.h"
#include "core/io/image.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {

namespace fs = std::filesystem;

// Driver: runs the program's own window and moves the real mouse of the display in it.
class Driver {
 public:
  explicit Driver(const Parameters& parameters) : loop(std::nullopt, parameters) {
    workspace().settings.language = LanguageChoice::english;  // whatever the machine speaks
    workspace().help.offered = false;                         // the tour would lie over what tests click on
    ImGui::GetIO().UserData = &rects_;
    ImGui::GetIO().MouseDoubleClickTime = 5;  // frames may be slow where many tests run
  }

  Workspace& workspace() { return loop.application().workspace(); }
  const Workspace& workspace() const { return loop.application().workspace(); }
  Session& session() { return workspace().session; }
  bool alive() const { return alive_; }
  const ui::WidgetRects& rects() const { return rects_; }

  void frames(int count) {
    for (int i = 0; (i < count || loop.eventsWait()) && alive_; ++i) {
      loop.requestFrame();
      alive_ = loop.frame();
    }
  }
  // wait: frames until the condition holds; false after `seconds`.
  bool wait(const std::function<bool()>& condition, double seconds = 60) {
    const Timer timer;
    while (!condition()) {
      if (timer.seconds() > seconds) return false;
      frames(1);
    }
    return true;
  }
  bool waitUntilIdle() {
    return wait([this] { return session().hasScan() && !session().activity().busy; });
  }

  bool knows(const std::string& widget) const { return rects_.byName.contains(widget); }
  // point: a place inside a widget, as shares of its sides.
  ImVec2 point(const std::string& widget, float x = 0.5f, float y = 0.5f) const {
    const auto found = rects_.byName.find(widget);
    if (found == rects_.byName.end()) {
      ADD_FAILURE() << "no widget " << widget;
      return {};
    }
    const auto& [min, max] = found->second;
    return {min.x + x * (max.x - min.x), min.y + y * (max.y - min.y)};
  }
  void mouse(const std::string& action) {
    ASSERT_EQ(std::system(("xdotool " + action).c_str()), 0) << action;
    frames(3);
  }
  void moveTo(ImVec2 p) { mouse("mousemove " + std::to_string(int(p.x)) + " " + std::to_string(int(p.y))); }
  void click(const std::string& widget) {
    moveTo(point(widget));
    mouse("mousedown 1");
    mouse("mouseup 1");
  }
  // openStep: by its row in the list of steps; its parameters are shown then.
  void openStep(Step step) {
    click(std::string("step.") + stepName(step));
    ASSERT_EQ(workspace().step, step);
    frames(2);
  }
  void drag(ImVec2 from, ImVec2 to, int button = 1) {
    moveTo(from);
    mouse("mousedown " + std::to_string(button));
    moveTo({0.5f * (from.x + to.x), 0.5f * (from.y + to.y)});
    moveTo(to);
    mouse("mouseup " + std::to_string(button));
  }
  void doubleClick(const std::string& widget) {
    moveTo(point(widget));
    for (const char* action : {"mousedown 1", "mouseup 1", "mousedown 1", "mouseup 1"}) mouse(action);
  }
  void press(const std::string& keys) {
    mouse("keydown " + keys);
    mouse("keyup " + keys);
  }

  // screenshot: the display's pixels as they are.
  Image screenshot(const std::string& name) {
    frames(3);
    const fs::path path = pictures_ / (name + ".png");
    EXPECT_EQ(std::system(("import -silent -window root -depth 8 png32:" + path.string()).c_str()), 0);
    return readPng(path);
  }

  WindowLoop loop;

 private:
  const test::TempFolder pictures_;
  ui::WidgetRects rects_;
  bool alive_ = true;
};

inline Parameters smallPhantom() {
  Parameters parameters;
  parameters.phantom.dims = {156, 85, 62};
  parameters.mesh.resolution = 120;
  return parameters;
}

struct Colour {
  int r, g, b;
};
inline Colour pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgba[4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))];
  return {p[0], p[1], p[2]};
}

// The share of the pixels of a pane, away from its marks, for which `test` holds.
inline double share(const Image& image, const Driver& driver, const char* pane,
                    const std::function<bool(Colour)>& test) {
  const ImVec2 from = driver.point(pane, 0.05f, 0.12f), to = driver.point(pane, 0.95f, 0.85f);
  int count = 0, all = 0;
  for (int y = int(from.y); y < int(to.y); ++y) {
    for (int x = int(from.x); x < int(to.x); ++x, ++all) count += test(pixel(image, x, y));
  }
  return all == 0 ? 0 : double(count) / all;
}

inline double difference(const Image& a, const Image& b, const Driver& driver, const char* pane) {
  const ImVec2 from = driver.point(pane, 0.05f, 0.12f), to = driver.point(pane, 0.95f, 0.85f);
  int count = 0, all = 0;
  for (int y = int(from.y); y < int(to.y); ++y) {
    for (int x = int(from.x); x < int(to.x); ++x, ++all) {
      count += std::abs(pixel(a, x, y).g - pixel(b, x, y).g) > 12;
    }
  }
  return all == 0 ? 0 : double(count) / all;
}

class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    // Neither the person's own settings and sessions are read or written, nor those of the test before.
    setenv("XDG_CONFIG_HOME", (folder.path() / "settings").c_str(), 1);
    setenv("XDG_STATE_HOME", (folder.path() / "state").c_str(), 1);
    driver = std::make_unique<Driver>(smallPhantom());
  }
  const test::TempFolder folder;
  std::unique_ptr<Driver> driver;
};

}  // namespace sonoskin
