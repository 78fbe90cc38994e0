#include "app/widgets/fields_ui.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/texts/texts.h"
#include "app/widgets/field_row.h"
#include "app/widgets/number_row.h"

namespace sonoskin::ui {
namespace {

// More steps than this on one track cannot be told apart with a mouse.
constexpr int kMostSliderSteps = 2500;

std::string defaultText(const std::string& standard) { return trf("Default {}", standard); }

// A whole number of a wide range is typed, or stepped by its buttons.
FieldsEdit editStepped(const FieldRow& row, int& value, int standard, Range<int> range) {
  int typed = value;
  ImGui::InputInt("##number", &typed, 1, 100);
  typed = std::clamp(typed, range.min, range.max);
  FieldsEdit edit{typed != value, ImGui::IsItemDeactivatedAfterEdit()};
  value = typed;
  edit |= finish(row, value, standard,
                 rangeText(std::to_string(range.min), withUnit(std::to_string(range.max), row.field),
                           std::to_string(standard)));
  return edit;
}

template <class T>
FieldsEdit closeNumber(const FieldRow& row, T& value, T standard, bool asked) {
  if (!(closeRow(row, value != standard) || asked) || value == standard) return {};
  value = standard;
  return {true, true};
}

}  // namespace

bool beginFields(const char* id) {
  if (!ImGui::BeginTable(id, 2)) return false;
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch, 0.42f);
  ImGui::TableSetupColumn("widget", ImGuiTableColumnFlags_WidthStretch, 0.58f);
  return true;
}

void endFields() { ImGui::EndTable(); }

FieldsEdit editField(const FieldRow& row, double& value, double standard, Range<double> range) {
  openRow(row);
  const bool named = !row.text.shown.empty();
  const NumberTrack track{range.min,
                          range.max,
                          range.logarithmic && range.min > 0,
                          false,
                          named ? row.text.shown : fieldNumber(value, range),
                          named ? "" : std::string(row.field.unit),
                          row.text.grab.value_or(value)};
  bool asked = false;
  FieldsEdit edit =
      editTrack(row, value, track,
                rangeText(fieldNumber(range.min, range), withUnit(fieldNumber(range.max, range), row.field),
                          fieldNumber(standard, range)),
                asked);
  return edit |= closeNumber(row, value, standard, asked);
}

FieldsEdit editField(const FieldRow& row, int& value, int standard, Range<int> range) {
  openRow(row);
  if (range.max - range.min > kMostSliderSteps) return editStepped(row, value, standard, range);
  const NumberTrack track{double(range.min),     double(range.max),           false,        true,
                          std::to_string(value), std::string(row.field.unit), double(value)};
  double number = value;
  bool asked = false;
  FieldsEdit edit =
      editTrack(row, number, track,
                rangeText(std::to_string(range.min), withUnit(std::to_string(range.max), row.field),
                          std::to_string(standard)),
                asked);
  edit.changed &= int(number) != value;
  value = int(number);
  return edit |= closeNumber(row, value, standard, asked);
}

FieldsEdit editField(const FieldRow& row, bool& value, bool standard) {
  openRow(row);
  FieldsEdit edit;
  edit.changed = edit.finished = ImGui::Checkbox("##box", &value);
  edit |= finish(row, value, standard, defaultText(tr(standard ? "on" : "off")));
  return edit;
}

FieldsEdit editField(const FieldRow& row, std::string& value, const std::string& standard) {
  openRow(row);
  FieldsEdit edit;
  edit.changed = ImGui::InputText("##text", &value);
  edit.finished = ImGui::IsItemDeactivatedAfterEdit();
  edit |= finish(row, value, standard, defaultText(standard.empty() ? tr("empty") : standard));
  return edit;
}

FieldsEdit editChoice(const FieldRow& row, int& value, int standard, std::span<const char* const> names) {
  openRow(row);
  std::vector<const char*> shown;
  for (const char* name : names) shown.push_back(tr(name));
  FieldsEdit edit;
  edit.changed = edit.finished =
      ImGui::Combo("##choice", &value, shown.data(), static_cast<int>(shown.size()));
  edit |= finish(row, value, standard, defaultText(shown[std::size_t(standard)]));
  return edit;
}

FieldsEdit editField(const FieldRow& row, Places& value, const Places& standard, Range<double>) {
  openRow(row);
  FieldsEdit edit;
  const std::string text = value.empty()       ? tr("none")
                           : value.size() == 1 ? tr("1 place")
                                               : trf("{} places", value.size());
  ImGui::BeginDisabled(value.empty());
  if (ImGui::Button((text + (value.empty() ? "" : tr(": forget")) + "###forget").c_str(),
                    {widgetWidth(), 0})) {
    value.clear();
    edit = {true, true};
  }
  ImGui::EndDisabled();
  edit |= finish(row, value, standard, defaultText(tr("none")));
  return edit;
}

FieldsEdit editField(const FieldRow& row, std::array<int, 3>& value, const std::array<int, 3>& standard,
                     Range<int> range) {
  openRow(row);
  FieldsEdit edit;
  std::array<int, 3> typed = value;
  ImGui::InputInt3("##numbers", typed.data());
  for (int& v : typed) v = std::clamp(v, range.min, range.max);
  edit = {typed != value, ImGui::IsItemDeactivatedAfterEdit()};
  value = typed;
  edit |= finish(row, value, standard,
                 rangeText(std::to_string(range.min), withUnit(std::to_string(range.max), row.field),
                           fmt::format("{} x {} x {}", standard[0], standard[1], standard[2])));
  return edit;
}

FieldsEdit editField(const FieldRow& row, std::array<double, 3>& value, const std::array<double, 3>& standard,
                     Range<double> range) {
  openRow(row);
  FieldsEdit edit;
  const float speed = static_cast<float>(std::min(0.1, (range.max - range.min) / 1000));
  edit.changed =
      ImGui::DragScalarN("##numbers", ImGuiDataType_Double, value.data(), 3, speed, &range.min, &range.max,
                         range.max - range.min <= 100 ? "%.3f" : "%.1f", ImGuiSliderFlags_AlwaysClamp);
  edit.finished = ImGui::IsItemDeactivatedAfterEdit();
  edit |= finish(row, value, standard,
                 rangeText(fieldNumber(range.min, range), withUnit(fieldNumber(range.max, range), row.field),
                           fmt::format("{}, {}, {}", standard[0], standard[1], standard[2])));
  return edit;
}

}  // namespace sonoskin::ui
