#pragma once

#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// drawGreyRows: the grey window of raw slices in the file's values, and a button for each of those that are ready to use.
void drawGreyRows(Workspace& workspace);

}  // namespace sonoskin::ui
