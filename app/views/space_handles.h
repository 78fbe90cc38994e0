#pragma once

#include "app/views/pane.h"
#include "app/views/tools.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// drawCropHandles, drawClipHandle: what can be dragged in 3D: a handle in the middle of each side of the crop box; the outline
// of the plane that cuts, with an arrow toward what it cuts away.
void drawCropHandles(const ToolState& state, const Workspace& workspace, const PaneInput& pane);
void drawClipHandle(const ToolState& state, const Workspace& workspace, const PaneInput& pane);

// alongLine: how far along a line of the world the place lies that the mouse points at, mm: where the line comes nearest to the
// mouse's ray. Along a line toward the eye, upward is away from it; there, differences count alone.
//   origin, direction  of the line; the direction is unit
double alongLine(const glm::vec3& origin, const glm::vec3& direction, const Camera& camera,
                 const PaneInput& pane);

}  // namespace sonoskin::ui
