#include "app/views/layouts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
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

SlicePlane planeOf(Pane pane) {
  if (pane == Pane::oblique) return std::nullopt;
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

Cells compareCells(const LayoutState& layout) {
  Cells cells;
  for (const Pane pane : {Pane::axial, Pane::sagittal, Pane::coronal})
    cells.push_back({.pane = pane,
                     .plane = layout.compared,
                     .layer = SliceLayer(cells.size()),
                     .cast = layout.layout == Layout::casts});
  cells.push_back({.pane = Pane::space});
  return cells;
}

Cells namedCells(std::span<const Pane> panes) {
  Cells cells;
  for (const Pane pane : panes) cells.push_back({.pane = pane, .plane = planeOf(pane)});
  return cells;
}

Cells cellsIn(const LayoutState& layout) {
  constexpr std::array<Pane, 5> kOblique{Pane::oblique, Pane::space, Pane::axial, Pane::coronal,
                                         Pane::sagittal};
  if (layout.layout == Layout::fourUp) return namedCells(kPanes);
  return layout.layout == Layout::oblique ? namedCells(kOblique) : compareCells(layout);
}

// A row of cells from one side of the area to the other: two meet at the divider, three are as wide as each other.
void placeRow(std::span<Cell> cells, ImVec2 corner, ImVec2 size, float divider) {
  const auto count = cells.size();
  float left = corner.x;
  for (std::size_t n = 0; n < count; ++n) {
    const float share = float(n + 1) / float(count);
    const bool last = n + 1 == count;
    const float right = last         ? corner.x + size.x
                        : count == 2 ? divider
                                     : corner.x + std::floor(share * (size.x + gap())) - gap();
    cells[n].corner = {left, corner.y};
    cells[n].size = {right - left, size.y};
    left = right + gap();
  }
}

}  // namespace

Cells cellsOf(const LayoutState& layout, ImVec2 corner, ImVec2 area) {
  const ImVec2 cross = crossing(layout, corner, area);
  Cells cells = cellsIn(layout);
  const std::span<Cell> all(cells);
  placeRow(all.first(2), corner, {area.x, cross.y - corner.y}, cross.x);
  const float lower = cross.y + gap();
  placeRow(all.subspan(2), {corner.x, lower}, {area.x, corner.y + area.y - lower}, cross.x);
  return cells;
}

void drawDividers(LayoutState& layout, ImVec2 corner, ImVec2 area) {
  const ImVec2 cross = crossing(layout, corner, area);
  const float wide = gap(), more = 3 * unit();
  const bool toTheEnd = layout.layout != Layout::oblique;  // three views lie below it
  // Where they cross both are held.
  drawDivider(
      {"divider.both", {cross.x - more, cross.y - more}, {wide + 2 * more, wide + 2 * more}, true, true},
      layout, corner, area);
  drawDivider(
      {"divider.across", {cross.x, corner.y}, {wide, toTheEnd ? area.y : cross.y - corner.y}, true, false},
      layout, corner, area);
  drawDivider({"divider.down", {corner.x, cross.y}, {area.x, wide}, false, true}, layout, corner, area);
}

}  // namespace sonoskin::ui
