#include "app/widgets/layout.h"

#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {

void section(const char* title) {
  ImGui::Dummy({0, 4 * unit()});
  ImGui::PushFont(headingFont());
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
  const ImVec2 left = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::GetWindowDrawList()->AddLine({left.x, left.y - 2 * unit()}, {left.x + width, left.y - 2 * unit()},
                                      ImGui::GetColorU32(ImGuiCol_Separator));
  ImGui::Dummy({0, 1 * unit()});
}

void heading(const char* title) {
  ImGui::Dummy({0, 2 * unit()});
  ImGui::PushFont(headingFont());
  ImGui::TextDisabled("%s", title);
  ImGui::PopFont();
}

void sentenceText(const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colours().faintText);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void fact(const char* label, const std::string& value, bool warning) {
  ImGui::TextDisabled("%s", label);
  ImGui::SameLine(ImGui::GetContentRegionAvail().x * 0.36f);
  ImGui::PushStyleColor(ImGuiCol_Text, warning ? colours().warning : colours().text);
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

namespace {

// The buttons are as wide as `width` says of their names.
template <class Width>
bool drawSegments(const char* id, std::initializer_list<const char*> names, int& chosen, const Width& width) {
  ImGui::PushID(id);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(1 * unit(), ImGui::GetStyle().ItemSpacing.y));
  bool changed = false;
  int index = 0;
  for (const char* name : names) {
    if (index > 0) ImGui::SameLine();
    if (switchButton(tr(name), index == chosen, width(name)) && index != chosen) {
      chosen = index;
      changed = true;
    }
    noteWidget(std::string(id) + "." + name);
    ++index;
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
  return changed;
}

float textButtonWidth(const char* name) {
  return ImGui::CalcTextSize(tr(name)).x + 2 * ImGui::GetStyle().FramePadding.x;
}

}  // namespace

bool segments(const char* id, std::initializer_list<const char*> names, int& chosen) {
  const float gaps = float(names.size() - 1) * unit();
  const float width = (ImGui::GetContentRegionAvail().x - gaps) / float(names.size());
  return drawSegments(id, names, chosen, [width](const char*) { return width; });
}

bool textSegments(const char* id, std::initializer_list<const char*> names, int& chosen) {
  return drawSegments(id, names, chosen, textButtonWidth);
}

float textSegmentsWidth(std::initializer_list<const char*> names) {
  float width = float(names.size() - 1) * unit();
  for (const char* name : names) width += textButtonWidth(name);
  return width;
}

// What is on keeps its colour below the mouse, only stronger.
bool switchButton(const char* title, bool on, float width) {
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, withAlpha(colours().accent, 0.42f));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, withAlpha(colours().accent, 0.54f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, withAlpha(colours().accent, 0.34f));
  }
  const bool pressed = ImGui::Button(title, {width, 0});
  if (on) ImGui::PopStyleColor(3);
  return pressed;
}

bool foldout(const char* title, const char* tooltip) {
  ImGui::PushID(title);
  bool* open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("open"));
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, ImVec2(0, 0.5f));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(22 * unit(), ImGui::GetStyle().FramePadding.y));
  if (ImGui::Button(tr(title), {-1, 0})) *open = !*open;
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  noteWidget(std::string("foldout.") + title);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tr(tooltip));
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const float u = unit(), r = 3.5f * u, x = min.x + 9 * u, y = 0.5f * (min.y + max.y);
  const ImU32 colour = ImGui::GetColorU32(colours().faintText);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (*open) {
    list.AddTriangleFilled({x - r, y - 0.6f * r}, {x + r, y - 0.6f * r}, {x, y + r}, colour);
  } else {
    list.AddTriangleFilled({x - 0.6f * r, y - r}, {x + r, y}, {x - 0.6f * r, y + r}, colour);
  }
  ImGui::PopID();
  return *open;
}

bool mainButton(const char* title, bool enabled) {
  const DisabledIf disabled(!enabled);
  ImGui::PushStyleColor(ImGuiCol_Button, withAlpha(colours().accent, 0.55f));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, withAlpha(colours().accent, 0.7f));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, withAlpha(colours().accent, 0.45f));
  const bool pressed = ImGui::Button(title, {-1, 34 * unit()});
  ImGui::PopStyleColor(3);
  return pressed;
}

}  // namespace sonoskin::ui
