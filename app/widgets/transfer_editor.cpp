#include "app/widgets/transfer_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/texts/texts.h"
#include "app/widgets/theme.h"
#include "app/widgets/transfer_points.h"
#include "app/widgets/widget_rects.h"
#include "render/srgb.h"

namespace sonoskin::ui {
namespace {

constexpr float kHeight = 118, kReach = 8;  // units: of the plot; from a point to the mouse that takes it

ImU32 packed(const glm::vec3& linear, float alpha) {
  const glm::vec3 c = toSrgb(glm::clamp(linear, 0.0f, 1.0f));
  return ImGui::GetColorU32(ImVec4(c.r, c.g, c.b, alpha));
}

// Curve: from values and opacities to the screen. Upward is the root of the opacity: a veil of one percent is seen in a
// picture, and so it is here.
struct Curve {
  ImVec2 min, max;

  ImVec2 at(float value, float opacity) const {
    return {min.x + value * (max.x - min.x), max.y - std::sqrt(opacity) * (max.y - min.y)};
  }
  float valueAt(float x) const { return std::clamp((x - min.x) / (max.x - min.x), 0.0f, 1.0f); }
  float opacityAt(float y) const {
    const float up = std::clamp((max.y - y) / (max.y - min.y), 0.0f, 1.0f);
    return up * up;
  }
};

int pointAt(const Curve& curve, const TransferFunction& transfer, ImVec2 mouse) {
  int nearest = -1;
  float least = kReach * unit();
  for (int p = 0; p < int(transfer.points.size()); ++p) {
    const auto& point = transfer.points[std::size_t(p)];
    const ImVec2 seen = curve.at(point.value, point.opacity);
    const float distance = std::hypot(seen.x - mouse.x, seen.y - mouse.y);
    if (distance >= least) continue;
    least = distance;
    nearest = p;
  }
  return nearest;
}

void drawBack(const Curve& curve, const TransferFunction& transfer, const TransferPlot& plot) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float margin = 6 * unit();
  list.AddRectFilled({curve.min.x - margin, curve.min.y - margin},
                     {curve.max.x + margin, curve.max.y + margin}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                     3 * unit());
  const float height = curve.max.y - curve.min.y,
              width = (curve.max.x - curve.min.x) / float(plot.histogram.size());
  for (std::size_t b = 0; b < plot.histogram.size(); ++b) {
    const float x = curve.min.x + float(b) * width;
    list.AddRectFilled({x, curve.max.y - plot.histogram[b] * height}, {x + width, curve.max.y},
                       ImGui::GetColorU32(withAlpha(colours().faintText, 0.28f)));
  }
  constexpr int kColumns = 128;
  list.Flags &= ~ImDrawListFlags_AntiAliasedFill;  // seams between the columns would show
  for (int c = 0; c < kColumns; ++c) {
    const float from = float(c) / kColumns, to = float(c + 1) / kColumns;
    const glm::vec4 left = transfer.at(from), right = transfer.at(to);
    list.AddQuadFilled(curve.at(from, 0), curve.at(from, left.a), curve.at(to, right.a), curve.at(to, 0),
                       packed(0.5f * glm::vec3(left + right), 0.72f));
    list.AddLine(curve.at(from, left.a), curve.at(to, right.a), ImGui::GetColorU32(colours().text),
                 1.3f * unit());
  }
  list.Flags |= ImDrawListFlags_AntiAliasedFill;
  const float x = curve.at(plot.level, 0).x;
  list.AddLine({x, curve.min.y}, {x, curve.max.y}, ImGui::GetColorU32(withAlpha(colours().accent, 0.7f)));
}

void drawPoints(const Curve& curve, const TransferFunction& transfer, int selected, int hovered) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int p = 0; p < int(transfer.points.size()); ++p) {
    const auto& point = transfer.points[std::size_t(p)];
    const ImVec2 place = curve.at(point.value, point.opacity);
    const float radius = (p == hovered || p == selected ? 5.5f : 4.5f) * unit();
    list.AddCircleFilled(place, radius, packed(point.colour, 1));
    list.AddCircle(place, radius, ImGui::GetColorU32(p == selected ? colours().accent : colours().text), 0,
                   (p == selected ? 2 : 1.3f) * unit());
    notePlace(fmt::format("transfer.{}", p), {place.x, place.y}, radius);
  }
}

bool isPressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

// The mouse and the keys over the plot.
FieldsEdit usePlot(const Curve& curve, TransferFunction& transfer, int& selected, int hovered) {
  FieldsEdit edit;
  const ImVec2 mouse = ImGui::GetMousePos();
  if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    selected = hovered;
    if (selected < 0) {
      selected = addPoint(transfer, curve.valueAt(mouse.x));
      edit.changed = true;
    }
  }
  const bool held = ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left) && selected >= 0;
  if (held && (edit.changed || ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0)) {
    movePoint(transfer, selected, curve.valueAt(mouse.x), curve.opacityAt(mouse.y));
    edit.changed = true;
  }
  if (ImGui::IsItemDeactivated()) edit.finished = true;
  const bool keys = !ImGui::GetIO().WantTextInput && ImGui::IsItemHovered() &&
                    (isPressed(ImGuiKey_Delete) || isPressed(ImGuiKey_Backspace));
  const bool right = ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  if ((keys && removePoint(transfer, selected)) || (right && removePoint(transfer, hovered))) {
    selected = -1;
    edit = {true, true};
  }
  return edit;
}

// The selected point in numbers.
FieldsEdit editPoint(TransferFunction& transfer, int point) {
  auto& chosen = transfer.points[std::size_t(point)];
  float value = chosen.value, opacity = chosen.opacity;
  glm::vec3 colour = toSrgb(chosen.colour);
  FieldsEdit edit;
  const auto note = [&edit](bool changed) {
    edit.changed |= changed;
    edit.finished |= ImGui::IsItemDeactivatedAfterEdit();
    return changed;
  };
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight()) - 8 * unit();
  if (note(ImGui::ColorEdit3("##colour", &colour.x,
                             ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel)))
    chosen.colour = fromSrgb(colour);
  noteWidget("transfer.colour");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(width);
  note(ImGui::DragFloat("##value", &value, 0.002f, 0, 1, tr("grey %.3f"), ImGuiSliderFlags_AlwaysClamp));
  noteWidget("transfer.value");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(width);
  note(ImGui::DragFloat("##opacity", &opacity, 0.002f, 0, 1, tr("opacity %.3f"),
                        ImGuiSliderFlags_AlwaysClamp));
  noteWidget("transfer.opacity");
  movePoint(transfer, point, value, opacity);
  return edit;
}

}  // namespace

FieldsEdit editTransfer(TransferFunction& transfer, const TransferPlot& plot, int& selected) {
  if (selected >= int(transfer.points.size())) selected = -1;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, kHeight * unit()};
  ImGui::InvisibleButton("transfer", size);
  noteWidget("transfer");
  const float margin = 7 * unit();
  const Curve curve{{corner.x + margin, corner.y + margin},
                    {corner.x + size.x - margin, corner.y + size.y - margin}};
  const int hovered = ImGui::IsItemHovered() ? pointAt(curve, transfer, ImGui::GetMousePos()) : -1;
  FieldsEdit edit = usePlot(curve, transfer, selected, hovered);
  drawBack(curve, transfer, plot);
  drawPoints(curve, transfer, selected, hovered);
  if (selected >= 0)
    edit |= editPoint(transfer, selected);
  else
    ImGui::TextDisabled("%s", tr("Click: a new point; right click: away"));
  return edit;
}

}  // namespace sonoskin::ui
