#pragma once

#include <imgui.h>

#include <optional>
#include <vector>

#include "app/workspace/layout_state.h"
#include "app/workspace/view_state.h"

namespace sonoskin::ui {

// Cell: a view of a layout, and where it lies on the screen.
//   layer  of what is compared; none: as the view state has it
//   cast   a ray-cast that is compared, in the place of a slice
struct Cell {
  Pane pane = Pane::axial;
  ImVec2 corner{}, size{};
  SlicePlane plane = Plane::axial;  // of a slice
  std::optional<SliceLayer> layer{};
  bool cast = false;
};
using Cells = std::vector<Cell>;

// cellsOf: the views of a layout, row by row, in an area of the screen, with room for the dividers between them. Four, or two
// above three.
Cells cellsOf(const LayoutState& layout, ImVec2 corner, ImVec2 area);

// drawDividers: between the cells of an area; dragged they move, double clicked they go back to the middle.
void drawDividers(LayoutState& layout, ImVec2 corner, ImVec2 area);

}  // namespace sonoskin::ui
