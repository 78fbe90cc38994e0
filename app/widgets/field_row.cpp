#include "app/widgets/field_row.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

#include "app/texts/texts.h"
#include "app/widgets/field_equations.h"
#include "app/widgets/symbol_text.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

float resetWidth() { return 20 * unit(); }
float gap() { return 4 * unit(); }

// A label that is too long for its column ends in dots, before the symbol.
void labelText(const std::string& text, float room) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  if (size.x <= room) return ImGui::TextUnformatted(text.c_str());
  const float lower = ImGui::GetCurrentWindow()->DC.CurrLineTextBaseOffset;
  ImGui::Dummy({room, ImGui::GetFontSize()});
  const ImVec2 min{ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y + lower},
      max{min.x + room, min.y + size.y};
  noteRect("cut." + text, min, max);  // for tests: none should be
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), min, max, max.x, max.x, text.c_str(), nullptr, &size);
}

void faintLine(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colours().faintText);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

void tooltip(const FieldRow& row, const std::string& facts) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsItemActive()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
  ImGui::TextUnformatted((capitalised(tr(row.field.help)) + ".").c_str());
  if (!row.text.found.empty()) ImGui::TextUnformatted(row.text.found.c_str());
  if (!row.text.unused.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, colours().warning);
    ImGui::TextUnformatted(trf("Not used now. {}.", row.text.unused).c_str());
    ImGui::PopStyleColor();
  }
  if (const std::string equation = equationOf(row.id); !equation.empty())
    ImGui::TextUnformatted(equation.c_str());
  if (!row.field.symbol.empty()) faintLine(trf("Symbol {}", greekSymbol(row.field.symbol)));
  faintLine(facts);
  faintLine(tr("Right click or double click: default"));
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace

void beginRow(const std::string& text, const std::string& symbol) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  const float symbolRoom = symbol.empty() ? 0 : symbolWidth(symbol) + 6 * unit();
  labelText(text, ImGui::GetContentRegionAvail().x - symbolRoom);
  if (!symbol.empty()) {
    ImGui::SameLine(0, 6 * unit());
    drawSymbol(symbol);
  }
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(widgetWidth());
}

void openRow(const FieldRow& row) {
  beginRow(row.text.label.empty() ? fieldLabel(row.field) : row.text.label, greekSymbol(row.field.symbol));
  ImGui::PushID(row.id.c_str());
  ImGui::BeginDisabled(!row.text.unused.empty());
}

float widgetWidth() { return ImGui::GetContentRegionAvail().x - resetWidth() - gap(); }

bool afterWidget(const FieldRow& row, const std::string& facts) {
  noteWidget(row.id);
  if (isWanted(row.id)) ImGui::SetScrollHereY();
  tooltip(row, facts);
  return ImGui::IsItemHovered() && (ImGui::IsMouseClicked(ImGuiMouseButton_Right) ||
                                    ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left));
}

bool closeRow(const FieldRow& row, bool differs) {
  ImGui::SameLine(0, gap());
  const ImVec2 size{resetWidth(), ImGui::GetFrameHeight()};
  bool pressed = false;
  if (differs) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    ImGui::PushStyleColor(ImGuiCol_Text, colours().accent);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, ImGui::GetStyle().FramePadding.y));
    pressed = ImGui::Button("↺##default", size);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    noteWidget(row.id + ".reset");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tr("Back to the default"));
  } else {
    ImGui::Dummy(size);
  }
  ImGui::EndDisabled();
  ImGui::PopID();
  return pressed;
}

std::string withUnit(const std::string& number, const Field& field) {
  return field.unit.empty() ? number : fmt::format("{} {}", number, tr(field.unit));
}

std::string rangeText(const std::string& from, const std::string& to, const std::string& standard) {
  return trf("{} to {}, default {}", from, to, standard);
}

}  // namespace sonoskin::ui
