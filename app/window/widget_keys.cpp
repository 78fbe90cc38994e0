#include "app/window/widget_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

namespace sonoskin {
namespace {

constexpr std::array kSteering{GLFW_KEY_LEFT, GLFW_KEY_RIGHT, GLFW_KEY_UP,
                               GLFW_KEY_DOWN, GLFW_KEY_SPACE, GLFW_KEY_ENTER};

}  // namespace

bool WidgetKeys::takeTab(bool back) {
  if (on_) {
    step_ = back ? -1 : 1;
  } else {
    on_ = ui::focusChild("side");
  }
  return true;
}

bool WidgetKeys::take(const Event& event) {
  const bool tab = event.kind == Event::Kind::key && event.down && event.code == GLFW_KEY_TAB;
  if (tab && ui::questionIsOpen()) {
    ui::leaveField();
    questionStep_ = event.shift ? -1 : 1;
    return true;
  }
  if (event.kind == Event::Kind::button && event.down) on_ = false;
  if (event.kind != Event::Kind::key || !event.down || ImGui::GetIO().WantTextInput) return false;
  if (ui::popupIsOpen() || !ui::mainHasKeys()) return false;
  if (event.code == GLFW_KEY_TAB && !event.control && !event.alt) return takeTab(event.shift);
  if (event.code == GLFW_KEY_ESCAPE) return std::exchange(on_, false);
  return on_ && !event.control && !event.alt && std::ranges::find(kSteering, event.code) != kSteering.end();
}

ui::KeySteering WidgetKeys::forFrame() {
  return {on_, std::exchange(step_, 0), std::exchange(questionStep_, 0)};
}

}  // namespace sonoskin
