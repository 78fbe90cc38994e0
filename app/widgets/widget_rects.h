#pragma once

#include <imgui.h>

#include <glm/glm.hpp>
#include <map>
#include <string>

namespace sonoskin::ui {

// WidgetRects: where the named widgets of the last frame are: for the tour, which points at them, and for tests that drive the
// window with a mouse; and which row is looked for. Noted only while ImGui's user data points here.
struct WidgetRects {
  struct Rect {
    ImVec2 min, max;
  };
  std::map<std::string, Rect> byName;
  std::string wanted;  // the row of a parameter that is to come into sight, if any
};

// noteRect: a part of the window that is no widget.
inline void noteRect(const std::string& name, const ImVec2& min, const ImVec2& max) {
  if (auto* rects = static_cast<WidgetRects*>(ImGui::GetIO().UserData)) rects->byName[name] = {min, max};
}

// noteWidget: the last widget, under a name.
inline void noteWidget(const std::string& name) {
  noteRect(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

// isWanted: whether the row of a parameter is to come into sight, with the keyboard in it.
inline bool isWanted(const std::string& row) {
  const auto* rects = static_cast<const WidgetRects*>(ImGui::GetIO().UserData);
  return rects && rects->wanted == row;
}

// notePlace: a mark of a view that is no widget, such as a lamp, around its middle.
inline void notePlace(const std::string& name, const glm::vec2& middle, float reach) {
  noteRect(name, {middle.x - reach, middle.y - reach}, {middle.x + reach, middle.y + reach});
}

}  // namespace sonoskin::ui
