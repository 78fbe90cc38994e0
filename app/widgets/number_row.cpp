#include "app/widgets/number_row.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/texts/texts.h"
#include "app/widgets/field_row.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

float numberWidth() { return 88 * unit(); }

// The track up to the grab, so that values can be compared at a glance.
void fillTrack(double share) {
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const float right = min.x + static_cast<float>(std::clamp(share, 0.0, 1.0)) * (max.x - min.x);
  ImGui::GetWindowDrawList()->AddRectFilled(min, {right, max.y},
                                            ImGui::GetColorU32(withAlpha(colours().accent, 0.16f)),
                                            ImGui::GetStyle().FrameRounding);
}

// The slider works on t in [0, 1], linear or by factors: ImGui's own logarithmic slider stops at 1e-3.
double toShare(double v, const NumberTrack& track) {
  return track.logarithmic ? std::log(v / track.min) / std::log(track.max / track.min)
                           : (v - track.min) / (track.max - track.min);
}

double fromShare(double t, const NumberTrack& track) {
  const double v = track.logarithmic ? track.min * std::pow(track.max / track.min, t)
                                     : track.min + t * (track.max - track.min);
  return std::clamp(track.whole ? std::round(v) : roundedForSlider(v), track.min, track.max);
}

// Typing: the one number that is being typed: whose, since how many frames, what, and what stood there first.
struct Typing {
  ImGuiID id = 0;
  int frames = 0;
  std::string text, before;
};
Typing& typing() {
  static Typing now;
  return now;
}

void beginTyping(ImGuiID id, double value) {
  const std::string text = fmt::format("{:.6g}", value);
  typing() = {id, 0, text, text};
}

// What was typed counts when Enter is pressed or something else is clicked; Escape leaves the number as it was.
FieldsEdit typeNumber(double& value, const NumberTrack& track) {
  Typing& now = typing();
  if (now.frames++ == 0) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(numberWidth());
  ImGui::InputText("##typed", &now.text, ImGuiInputTextFlags_AutoSelectAll);
  const bool ended = ImGui::IsItemDeactivated() || (now.frames > 3 && !ImGui::IsItemActive());
  if (!ended) return {};
  now.id = 0;
  const auto typed = now.text == now.before ? std::optional<double>() : numberTyped(now.text);
  if (!typed) return {};
  const double fitting = std::clamp(track.whole ? std::round(*typed) : *typed, track.min, track.max);
  if (fitting == value) return {};
  value = fitting;
  return {true, true};
}

// The number at the right of its place, the unit fainter behind it; true when it was clicked.
bool numberBox(const NumberTrack& track) {
  const ImVec2 size{numberWidth(), ImGui::GetFrameHeight()};
  const bool clicked = ImGui::InvisibleButton("number", size);
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) {
    list.AddRectFilled(min, max, ImGui::GetColorU32(ImGuiCol_FrameBgHovered),
                       ImGui::GetStyle().FrameRounding);
    ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    ImGui::SetTooltip("%s", tr("Click to type a number"));
  }
  const std::string unit = tr(std::string_view(track.unit));
  const bool per = unit.starts_with("1/");  // "0.1 /voxel": room is scarce
  const std::string unitText = unit.empty() ? "" : " " + unit.substr(per ? 1 : 0);
  const float unitWidth = ImGui::CalcTextSize(unitText.c_str()).x;
  const float y = min.y + ImGui::GetStyle().FramePadding.y, right = max.x - 4 * ui::unit();
  const float width = ImGui::CalcTextSize(track.shown.c_str()).x + unitWidth;
  list.PushClipRect(min, max, true);
  const float x = std::max(right - width, min.x);
  list.AddText({x, y}, ImGui::GetColorU32(ImGuiCol_Text), track.shown.c_str());
  list.AddText({x + width - unitWidth, y}, ImGui::GetColorU32(ImGuiCol_TextDisabled), unitText.c_str());
  list.PopClipRect();
  return clicked;
}

FieldsEdit dragTrack(double& value, const NumberTrack& track) {
  FieldsEdit edit;
  const double standing = std::clamp(toShare(track.grab, track), 0.0, 1.0), zero = 0, one = 1;
  double t = standing;
  ImGui::SetNextItemWidth(widgetWidth() - numberWidth() - 4 * unit());
  if (ImGui::SliderScalar("##slider", ImGuiDataType_Double, &t, &zero, &one, "", ImGuiSliderFlags_NoInput) &&
      t != standing) {
    value = fromShare(t, track);
    edit.changed = true;
  }
  edit.finished = ImGui::IsItemDeactivatedAfterEdit();
  fillTrack(t);
  return edit;
}

}  // namespace

FieldsEdit editTrack(const FieldRow& row, double& value, const NumberTrack& track, const std::string& facts,
                     bool& asked) {
  FieldsEdit edit = dragTrack(value, track);
  const ImGuiID id = ImGui::GetID("number");
  const bool byTrack = ImGui::IsItemClicked() && ImGui::GetIO().KeyCtrl;
  asked = afterWidget(row, facts);
  ImGui::SameLine(0, 4 * unit());
  if (typing().id == id) {
    edit |= typeNumber(value, track);
  } else if (numberBox(track) || byTrack || isWanted(row.id)) {
    beginTyping(id, value);
  }
  noteWidget(row.id + ".number");
  return edit;
}

std::optional<double> numberTyped(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  const char* begin = text.data();
  const char* end = begin + text.size();
  while (begin != end && (*begin == ' ' || *begin == '+')) ++begin;
  double number = 0;
  const auto [rest, error] = std::from_chars(begin, end, number);
  if (error != std::errc() || !std::isfinite(number)) return {};
  return number;
}

}  // namespace sonoskin::ui
