#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "app/widgets/widget_rects.h"
#include "app/window/application.h"
#include "core/base/timer.h"
#include "core/io/image.h"

namespace sonoskin::test {

// Act: one thing that a hand does.
//   at    move: where the mouse goes
//   text  key: "ctrl+shift+z", "Return", as xdotool has them; type: the characters
struct Act {
  enum class Kind { move, press, release, key, type };
  Kind kind;
  ImVec2 at{};
  std::string text{};
};

inline Act moveTo(ImVec2 at) { return {Act::Kind::move, at}; }
inline Act press() { return {Act::Kind::press}; }
inline Act release() { return {Act::Kind::release}; }
inline Act keyPress(std::string keys) { return {Act::Kind::key, {}, std::move(keys)}; }
inline Act typing(std::string text) { return {Act::Kind::type, {}, std::move(text)}; }

// Player: somebody who works with the application, by a mouse and keys of some kind.
class Player {
 public:
  virtual ~Player() = default;

  virtual Application& application() = 0;
  virtual const ui::WidgetRects& rects() const = 0;
  // frames: so many, and those that what has happened needs.
  virtual void frames(int count) = 0;
  // hand: what is done at once, before the next frame is over, and the frames that answer.
  virtual void hand(const std::vector<Act>& acts) = 0;
  // picture: what is seen now.
  virtual Image picture() = 0;
  // restart: the program, which has ended, begins anew.
  virtual void restart() = 0;

  Workspace& workspace() { return application().workspace(); }
  Session& session() { return workspace().session; }
  ViewState& view() { return workspace().view; }

  // wait: frames until the condition holds; false after two minutes.
  bool wait(const std::function<bool()>& condition) {
    const Timer timer;
    while (!condition()) {
      if (timer.seconds() > 120) return false;
      frames(1);
    }
    return true;
  }
  bool untilIdle() {
    return wait([this] { return session().hasScan() && !session().activity().busy; });
  }

  // stillPicture: what is seen once no view wants to be drawn better, and no message comes or goes.
  Image stillPicture() {
    workspace().toasts.list.clear();
    EXPECT_TRUE(wait([this] { return std::isinf(application().secondsToNext()); }));
    return picture();
  }

  bool knows(const std::string& widget) const { return rects().byName.contains(widget); }
  // point: a place inside a widget, as shares of its sides.
  ImVec2 point(const std::string& widget, float x = 0.5f, float y = 0.5f) const {
    const auto found = rects().byName.find(widget);
    if (found == rects().byName.end()) {
      ADD_FAILURE() << "no widget " << widget;
      return {};
    }
    const auto& [min, max] = found->second;
    return {min.x + x * (max.x - min.x), min.y + y * (max.y - min.y)};
  }
  void click(ImVec2 at) { hand({moveTo(at), press(), release()}); }
  void click(const std::string& widget) { click(point(widget)); }
  void key(const std::string& keys) { hand({keyPress(keys)}); }
  // stroke: the button goes down at the first place and up at the last one.
  void stroke(const std::vector<ImVec2>& places) {
    std::vector<Act> acts{moveTo(places[0]), press()};
    for (const ImVec2& place : places) acts.push_back(moveTo(place));
    acts.push_back(release());
    hand(acts);
  }

  std::filesystem::path folder;  // in which the session's files lie
};

// difference: the share of the pixels of a pane, away from its marks, that are not the same in two pictures.
inline double difference(const Image& a, const Image& b, const Player& player, const char* pane) {
  const ImVec2 from = player.point(pane, 0.05f, 0.12f), to = player.point(pane, 0.95f, 0.85f);
  int count = 0, all = 0;
  for (int y = int(from.y); y < int(to.y); ++y) {
    for (int x = int(from.x); x < int(to.x); ++x, ++all) {
      const std::size_t at = 4 * (std::size_t(y) * std::size_t(a.width) + std::size_t(x)) + 1;
      count += std::abs(a.rgba[at] - b.rgba[at]) > 12;
    }
  }
  return all == 0 ? 1 : double(count) / all;
}

}  // namespace sonoskin::test
