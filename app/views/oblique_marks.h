#pragma once

#include <array>
#include <optional>

#include "app/views/tools.h"

namespace sonoskin::ui {

// obliqueEnds: where the oblique plane's line in another slice is taken to turn the plane: pixels from the view's upper left
// corner; nothing where the two are nearly parallel, or the line is not in sight.
std::optional<std::array<glm::vec2, 2>> obliqueEnds(const Workspace& workspace, const ToolPane& pane);

// endUnderMouse: which of them the mouse takes.
std::optional<std::size_t> endUnderMouse(const Workspace& workspace, const ToolPane& pane);

// drawPlaneLines: in the oblique slice the lines of the three planes; in those, where the layout has an oblique slice, its line
// with an end on each side that can be dragged.
void drawPlaneLines(const ToolState& state, const Workspace& workspace, const ToolPane& pane);

// drawObliqueInSpace: the oblique slice's frame in 3D: its border within the volume.
void drawObliqueInSpace(const PaneInput& pane, const Workspace& workspace);

}  // namespace sonoskin::ui
