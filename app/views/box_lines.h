#pragma once

#include "app/views/pane.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// showsBoxInSpace: whether the 3D view has the crop box: it would lie over the face of a finished surface, where only somebody who
// sets the region looks for it.
bool showsBoxInSpace(const Workspace& workspace);
// drawBoxLines: the twelve edges of the crop box as the 3D view's camera sees them.
void drawBoxLines(const PaneInput& pane, const Workspace& workspace);

}  // namespace sonoskin::ui
