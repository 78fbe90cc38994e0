#pragma once

#include "app/views/pane.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// drawBoxLines: the twelve edges of the crop box as the 3D view's camera sees them.
void drawBoxLines(const PaneInput& pane, const Workspace& workspace);

}  // namespace sonoskin::ui
