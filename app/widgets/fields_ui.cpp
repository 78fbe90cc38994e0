#include "app/widgets/fields_ui.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

// More steps than this on one slider cannot be told apart with a mouse.
constexpr int kMostSliderSteps = 2500;

// Escapes text for a place where printf would read it.
std::string literal(const std::string& text) {
  std::string result;
  for (const char c : text) result.append(c == '%' ? 2 : 1, c);
  return result;
}

std::string withUnit(const std::string& number, const Field& field) {
  return field.unit.empty() ? number : fmt::format("{} {}", number, field.unit);
}

// The left cell; the widget comes next.
void label(const FieldRow& row) {
  beginRow(row.text.label.empty() ? fieldLabel(row.field) : row.text.label, greekSymbol(row.field.symbol));
  ImGui::PushID(row.id.c_str());
  ImGui::BeginDisabled(!row.text.unused.empty());
}

void tooltip(const FieldRow& row, const std::string& facts) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsItemActive()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22);
  std::string help(row.field.help);
  if (!help.empty()) help[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(help[0])));
  ImGui::TextUnformatted((help + ".").c_str());
  if (!row.text.found.empty()) ImGui::TextUnformatted(row.text.found.c_str());
  if (!row.text.unused.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
    ImGui::TextUnformatted(fmt::format("Not used now. {}.", row.text.unused).c_str());
    ImGui::PopStyleColor();
  }
  ImGui::PushStyleColor(ImGuiCol_Text, kFaintText);
  if (!row.field.symbol.empty()) ImGui::Text("Symbol %s", greekSymbol(row.field.symbol).c_str());
  ImGui::TextUnformatted(facts.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

// After the widget: its name for tests, its tooltip, and the way back to the default.
template <class T>
FieldsEdit finish(const FieldRow& row, T& value, const T& standard, const std::string& facts) {
  ImGui::EndDisabled();
  noteWidget(row.id);
  tooltip(row, facts + "\nRight click or double click: default");
  ImGui::PopID();
  const bool reset = ImGui::IsItemHovered() && (ImGui::IsMouseClicked(ImGuiMouseButton_Right) ||
                                                ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left));
  if (!reset || value == standard) return {};
  value = standard;
  return {true, true};
}

std::string rangeText(const std::string& from, const std::string& to, const std::string& standard) {
  return fmt::format("{} to {}, default {}", from, to, standard);
}

// The slider's track up to the grab, so that values can be compared at a glance.
void fillTrack(double share) {
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const float right = min.x + static_cast<float>(std::clamp(share, 0.0, 1.0)) * (max.x - min.x);
  ImVec4 colour = kAccent;
  colour.w = 0.16f;
  ImGui::GetWindowDrawList()->AddRectFilled(min, {right, max.y}, ImGui::GetColorU32(colour),
                                            ImGui::GetStyle().FrameRounding);
}

// A slider is replaced by a text input after Ctrl+click: then the window's storage counts the frames since.
bool typing() { return ImGui::GetStateStorage()->GetInt(ImGui::GetID("typing"), 0) > 0; }
void beginTyping() { ImGui::GetStateStorage()->SetInt(ImGui::GetID("typing"), 1); }

// What is typed counts when Enter is pressed, and is forgotten when something else is clicked.
FieldsEdit typeNumber(double& value, Range<double> range) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID frames = ImGui::GetID("typing");
  const int count = storage.GetInt(frames);
  if (count == 1) ImGui::SetKeyboardFocusHere();
  double typed = value;
  const bool entered =
      ImGui::InputDouble("##typed", &typed, 0, 0, "%.6g",
                         ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
  storage.SetInt(frames, count + 1);
  if (entered || (count > 3 && !ImGui::IsItemActive())) storage.SetInt(frames, 0);
  if (!entered) return {};
  typed = std::clamp(typed, range.min, range.max);
  if (typed == value) return {};
  value = typed;
  return {true, true};
}

}  // namespace

void beginRow(const std::string& text, const std::string& symbol) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text.c_str());
  if (symbol.size() == 2 && (symbol[0] & 0x80) != 0) {  // one Greek letter
    ImGui::SameLine();
    ImGui::TextDisabled("%s", symbol.c_str());
  }
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
}

bool beginFields(const char* id) {
  if (!ImGui::BeginTable(id, 2)) return false;
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch, 0.46f);
  ImGui::TableSetupColumn("widget", ImGuiTableColumnFlags_WidthStretch, 0.54f);
  return true;
}

void endFields() { ImGui::EndTable(); }

// The slider works on t in [0, 1], linear or by factors: ImGui's own logarithmic slider stops at 1e-3.
FieldsEdit editField(const FieldRow& row, double& value, double standard, Range<double> range) {
  label(row);
  const bool byFactors = range.logarithmic && range.min > 0;
  const auto toSlider = [&](double v) {
    return byFactors ? std::log(v / range.min) / std::log(range.max / range.min)
                     : (v - range.min) / (range.max - range.min);
  };
  const auto fromSlider = [&](double t) {
    const double v =
        byFactors ? range.min * std::pow(range.max / range.min, t) : range.min + t * (range.max - range.min);
    return std::clamp(roundedForSlider(v), range.min, range.max);
  };
  FieldsEdit edit;
  if (typing()) {
    edit = typeNumber(value, range);
  } else {
    const double standing = toSlider(row.text.grab.value_or(value));
    double t = standing;
    const double zero = 0, one = 1;
    const std::string shown =
        literal(row.text.shown.empty() ? withUnit(fieldNumber(value, range), row.field) : row.text.shown);
    if (ImGui::SliderScalar("##slider", ImGuiDataType_Double, &t, &zero, &one, shown.c_str(),
                            ImGuiSliderFlags_NoInput) &&
        t != standing) {
      value = fromSlider(t);
      edit.changed = true;
    }
    edit.finished = ImGui::IsItemDeactivatedAfterEdit();
    fillTrack(t);
    if (ImGui::IsItemClicked() && ImGui::GetIO().KeyCtrl) beginTyping();
  }
  edit |= finish(row, value, standard,
                 rangeText(fieldNumber(range.min, range), withUnit(fieldNumber(range.max, range), row.field),
                           fieldNumber(standard, range)));
  return edit;
}

FieldsEdit editField(const FieldRow& row, int& value, int standard, Range<int> range) {
  label(row);
  FieldsEdit edit;
  if (range.max - range.min <= kMostSliderSteps) {
    const std::string format = withUnit("%d", row.field);
    edit.changed = ImGui::SliderInt("##slider", &value, range.min, range.max, format.c_str(),
                                    ImGuiSliderFlags_AlwaysClamp);
    edit.finished = ImGui::IsItemDeactivatedAfterEdit();
    fillTrack(double(value - range.min) / std::max(1, range.max - range.min));
  } else {
    int typed = value;
    ImGui::InputInt("##number", &typed, 1, 100);
    typed = std::clamp(typed, range.min, range.max);
    edit.finished = ImGui::IsItemDeactivatedAfterEdit();
    edit.changed = typed != value;
    value = typed;
  }
  const std::string last = withUnit(std::to_string(range.max), row.field);
  edit |= finish(row, value, standard, rangeText(std::to_string(range.min), last, std::to_string(standard)));
  return edit;
}

FieldsEdit editField(const FieldRow& row, bool& value, bool standard) {
  label(row);
  FieldsEdit edit;
  edit.changed = edit.finished = ImGui::Checkbox("##box", &value);
  edit |= finish(row, value, standard, standard ? "Default on" : "Default off");
  return edit;
}

FieldsEdit editField(const FieldRow& row, std::string& value, const std::string& standard) {
  label(row);
  FieldsEdit edit;
  edit.changed = ImGui::InputText("##text", &value);
  edit.finished = ImGui::IsItemDeactivatedAfterEdit();
  edit |= finish(row, value, standard, standard.empty() ? "Default empty" : "Default " + standard);
  return edit;
}

FieldsEdit editChoice(const FieldRow& row, int& value, int standard, std::span<const char* const> names) {
  label(row);
  FieldsEdit edit;
  edit.changed = edit.finished =
      ImGui::Combo("##choice", &value, names.data(), static_cast<int>(names.size()));
  edit |= finish(row, value, standard, std::string("Default ") + names[std::size_t(standard)]);
  return edit;
}

FieldsEdit editField(const FieldRow& row, Places& value, const Places& standard, Range<double>) {
  label(row);
  FieldsEdit edit;
  const std::string text = value.empty()       ? "none"
                           : value.size() == 1 ? "1 place"
                                               : fmt::format("{} places", value.size());
  ImGui::BeginDisabled(value.empty());
  if (ImGui::Button((text + (value.empty() ? "" : ": forget") + "###forget").c_str(), ImVec2(-1, 0))) {
    value.clear();
    edit = {true, true};
  }
  ImGui::EndDisabled();
  edit |= finish(row, value, standard, "Default none");
  return edit;
}

FieldsEdit editField(const FieldRow& row, std::array<int, 3>& value, const std::array<int, 3>& standard,
                     Range<int> range) {
  label(row);
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
  label(row);
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
