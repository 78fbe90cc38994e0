#pragma once

#include <imgui.h>

#include <glm/glm.hpp>
#include <map>
#include <string>

namespace sonoskin::ui {

// WidgetRects: where the named widgets of the last frame are, for tests that drive the window with a mouse.
// They are noted only while ImGui's user data points here; the program itself never sets it.
struct WidgetRects {
  struct Rect {
    ImVec2 min, max;
  };
  std::map<std::string, Rect> byName;
};

// noteWidget: the last widget, under a name.
inline void noteWidget(const std::string& name) {
  if (auto* rects = static_cast<WidgetRects*>(ImGui::GetIO().UserData)) {
    rects->byName[name] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
  }
}

// notePlace: a mark of a view that is no widget, such as a lamp, around its middle.
inline void notePlace(const std::string& name, const glm::vec2& middle, float reach) {
  if (auto* rects = static_cast<WidgetRects*>(ImGui::GetIO().UserData)) {
    rects->byName[name] = {{middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + reach}};
  }
}

}  // namespace sonoskin::ui
