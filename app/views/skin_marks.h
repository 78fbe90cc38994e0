#pragma once

#include "app/views/tools.h"

namespace sonoskin::ui {

// drawSkinMarks: what is shown over skin: lamp, line between the halves, landmarks, and how far light spreads.
void drawSkinMarks(const ToolState& state, const Workspace& workspace, const PaneInput& pane);

}  // namespace sonoskin::ui
