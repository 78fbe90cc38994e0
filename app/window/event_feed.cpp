#include "app/window/event_feed.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <iterator>

namespace sonoskin {
namespace {

constexpr double kLeastSeconds = 1e-4;  // ImGui's time must go on

void setKey(const Event& event, ImGuiIO& io) {
  if (event.code < 0 || event.code >= int(std::size(io.KeysDown))) return;  // GLFW has no name for some
  io.KeysDown[event.code] = event.down;
  const auto either = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
  io.KeyCtrl = either(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
  io.KeyShift = either(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  io.KeyAlt = either(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  io.KeySuper = either(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
}

}  // namespace

void EventFeed::note(const Event& event, ImGuiIO& io) {
  switch (event.kind) {
    case Event::Kind::position:
      mouse_ = event.at;
      break;
    case Event::Kind::button:
      if (event.code >= 0 && event.code < int(down_.size())) down_[std::size_t(event.code)] = event.down;
      break;
    case Event::Kind::wheel:
      io.MouseWheelH += event.at.x;
      io.MouseWheel += event.at.y;
      break;
    case Event::Kind::key:
      setKey(event, io);
      break;
    case Event::Kind::text:
      for (const char32_t character : event.text) io.AddInputCharacter(character);
      break;
    case Event::Kind::focus:
      io.AddFocusEvent(event.down);
      break;
  }
}

void EventFeed::feed(const std::optional<Event>& event, double now, ImGuiIO& io) {
  if (event) note(*event, io);
  io.MousePos = {mouse_.x, mouse_.y};
  std::ranges::copy(down_, std::begin(io.MouseDown));
  const double time = std::max(event ? event->time : now, time_ + kLeastSeconds);
  io.DeltaTime = float(time - time_);
  time_ = time;
}

}  // namespace sonoskin
