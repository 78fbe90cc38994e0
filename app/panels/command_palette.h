#pragma once

#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// drawPalette: the field that finds commands and parameters by their words, with those it found below; a window of its own. Up, Down and Enter
// or the mouse choose one; Escape or a click elsewhere closes it.
void drawPalette(Workspace& workspace);

}  // namespace sonoskin::ui
