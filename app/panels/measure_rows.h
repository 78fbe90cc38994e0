#pragma once

#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// drawMeasureRows: what is measured: a button for each kind, and a line with the value of each measure, which goes to its slice
// and can be deleted.
void drawMeasureRows(Workspace& workspace);

}  // namespace sonoskin::ui
