#pragma once

#include <glm/glm.hpp>

#include "app/views/pane.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// Marks over the skin view that the mouse can take.

// dialRadius: of the lamp's dial, pixels; see app/workspace/lamp_dial.h. lampPlace: the lamp's mark, from the pane's corner.
float dialRadius(const PaneInput& pane);
glm::vec2 lampPlace(const Workspace& workspace, const PaneInput& pane);

// isOnLamp, isOnDivider: whether the mouse is near enough to take it, where it is shown.
bool isOnLamp(const Workspace& workspace, const PaneInput& pane);
bool isOnDivider(const Workspace& workspace, const PaneInput& pane);

// drawLamp: the movable light: far ones have rays, near ones are a lamp; those behind the surface are hollow. `near`:
// the mouse is there: the dial's rim is shown too, and the distance.
void drawLamp(const Workspace& workspace, const PaneInput& pane, bool near);

// drawDivider: the line between the halves, and what they are.
void drawDivider(const Workspace& workspace, const PaneInput& pane, bool near);

}  // namespace sonoskin::ui
