#pragma once

#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// More of what the 3D view shows, in the list that its bar opens.

// drawVolumeRows: of a volume; drawClipRows: the plane that cuts what is shown.
void drawVolumeRows(Workspace& workspace);
void drawClipRows(Workspace& workspace);

// drawComparedRows: how the ray-casts beside it are shown, where they are compared.
void drawComparedRows(Workspace& workspace);

// drawObliqueNumbers: the angles of the oblique slice, and a button that sets them back; obliqueNumbersWidth: of all of it.
void drawObliqueNumbers(Workspace& workspace);
float obliqueNumbersWidth();

// drawColoursRow: which transfer function a translucent volume has; between beginFields() and endFields().
void drawColoursRow(Workspace& workspace);

}  // namespace sonoskin::ui
