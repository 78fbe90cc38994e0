#include "app/views/layouts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

float gap() { return std::round(5 * unit()); }

// The upper left corner of the place where the dividers cross.
ImVec2 crossing(const LayoutState& layout, ImVec2 corner, ImVec2 area) {
  return {corner.x + std::floor(layout.across * (area.x - gap())),
          corner.y + std::floor(layout.down * (area.y - gap()))};
}

Plane planeOf(Pane pane) {
  return pane == Pane::sagittal ? Plane::sagittal : pane == Pane::coronal ? Plane::coronal : Plane::axial;
}

// Divider: one of them, or the place where they cross, and which of them it moves.
struct Divider {
  const char* id;
  ImVec2 corner, size;
  bool across, down;
};

float shareAt(float mouse, float from, float length) {
  return std::clamp((mouse - from) / (length - gap()), kLeastShare, kMostShare);
}

void drawDivider(const Divider& divider, LayoutState& layout, ImVec2 corner, ImVec2 area) {
  ImGui::SetCursorScreenPos(divider.corner);
  ImGui::InvisibleButton(divider.id, divider.size);
  noteWidget(divider.id);
  const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (held || hovered)
    ImGui::SetMouseCursor(divider.across && divider.down ? ImGuiMouseCursor_ResizeAll
                          : divider.across               ? ImGuiMouseCursor_ResizeEW
                                                         : ImGuiMouseCursor_ResizeNS);
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    if (divider.across) layout.across = 0.5f;
    if (divider.down) layout.down = 0.5f;
  } else if (held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (divider.across) layout.across = shareAt(mouse.x, corner.x, area.x);
    if (divider.down) layout.down = shareAt(mouse.y, corner.y, area.y);
  }
  if (!held && !hovered) return;
  ImVec4 colour = kAccent;
  colour.w = held ? 0.9f : 0.5f;
  ImGui::GetWindowDrawList()->AddRectFilled(
      divider.corner, {divider.corner.x + divider.size.x, divider.corner.y + divider.size.y},
      ImGui::GetColorU32(colour));
}

}  // namespace

Cells cellsOf(const LayoutState& layout, ImVec2 corner, ImVec2 area) {
  const ImVec2 cross = crossing(layout, corner, area);
  const std::array<float, 2> x{corner.x, cross.x + gap()}, y{corner.y, cross.y + gap()};
  const std::array<float, 2> width{cross.x - corner.x, corner.x + area.x - x[1]},
      height{cross.y - corner.y, corner.y + area.y - y[1]};
  constexpr std::array<Pane, 4> kCompared{Pane::axial, Pane::sagittal, Pane::coronal, Pane::space};
  constexpr std::array<SliceLayer, 3> kLayers{SliceLayer::raw, SliceLayer::classified, SliceLayer::thinned};
  const bool compares = layout.layout != Layout::fourUp;
  Cells cells(4);
  for (std::size_t n = 0; n < 4; ++n) {
    Cell& cell = cells[n];
    cell.pane = compares ? kCompared[n] : kPanes[n];
    cell.corner = {x[n % 2], y[n / 2]};
    cell.size = {width[n % 2], height[n / 2]};
    cell.plane = compares ? layout.compared : planeOf(cell.pane);
    if (!compares || cell.pane == Pane::space) continue;
    cell.layer = kLayers[n];
    cell.cast = layout.layout == Layout::casts;
  }
  return cells;
}

void drawDividers(LayoutState& layout, ImVec2 corner, ImVec2 area) {
  const ImVec2 cross = crossing(layout, corner, area);
  const float wide = gap(), more = 3 * unit();
  // Where they cross both are held.
  drawDivider(
      {"divider.both", {cross.x - more, cross.y - more}, {wide + 2 * more, wide + 2 * more}, true, true},
      layout, corner, area);
  drawDivider({"divider.across", {cross.x, corner.y}, {wide, area.y}, true, false}, layout, corner, area);
  drawDivider({"divider.down", {corner.x, cross.y}, {area.x, wide}, false, true}, layout, corner, area);
}

}  // namespace sonoskin::ui
