#include "app/widgets/layout.h"

#include <fmt/format.h>

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

void fact(const char* label, const std::string& value, bool warning) {
  ImGui::TextDisabled("%s", label);
  ImGui::SameLine(ImGui::GetContentRegionAvail().x * 0.36f);
  ImGui::PushStyleColor(ImGuiCol_Text, warning ? kWarning : kText);
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

bool segments(const char* id, std::initializer_list<const char*> names, int& chosen) {
  ImGui::PushID(id);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(1 * unit(), ImGui::GetStyle().ItemSpacing.y));
  const float gaps = float(names.size() - 1) * ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gaps) / float(names.size());
  bool changed = false;
  int index = 0;
  for (const char* name : names) {
    if (index > 0) ImGui::SameLine();
    const bool down = index == chosen;
    if (down) ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(kAccent.x, kAccent.y, kAccent.z, 0.42f));
    if (ImGui::Button(name, {width, 0}) && !down) {
      chosen = index;
      changed = true;
    }
    noteWidget(std::string(id) + "." + name);
    if (down) ImGui::PopStyleColor();
    ++index;
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
  return changed;
}

bool foldout(const char* title, const char* tooltip) {
  ImGui::PushID(title);
  bool* open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("open"));
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, ImVec2(0, 0.5f));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(22 * unit(), ImGui::GetStyle().FramePadding.y));
  if (ImGui::Button(title, {-1, 0})) *open = !*open;
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  noteWidget(std::string("foldout.") + title);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tooltip);
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const float u = unit(), r = 3.5f * u, x = min.x + 9 * u, y = 0.5f * (min.y + max.y);
  const ImU32 colour = ImGui::GetColorU32(kFaintText);
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
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(kAccent.x, kAccent.y, kAccent.z, 0.55f));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImVec4(kAccent.x, kAccent.y, kAccent.z, 0.7f));
  ImGui::PushStyleColor(ImGuiCol_ButtonActive, ImVec4(kAccent.x, kAccent.y, kAccent.z, 0.45f));
  const bool pressed = ImGui::Button(title, {-1, 34 * unit()});
  ImGui::PopStyleColor(3);
  return pressed;
}

std::string grouped(std::size_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string millimetres(double value) {
  return fmt::format("{:.{}f}", value, std::abs(value) < 1 ? 3 : std::abs(value) < 10 ? 2 : 1);
}

}  // namespace sonoskin::ui
