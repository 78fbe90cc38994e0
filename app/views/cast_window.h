#pragma once

#include "app/views/space_window.h"

namespace sonoskin::ui {

// drawCast: one of the ray-casts that are compared, of the window's layer, with its marks; the mouse steers the camera of all.
//   output  seconds after which it wants a frame; negative for never
double drawCast(SpaceWindow& window, GpuScans& scans, Workspace& workspace, const PaneInput& pane);

}  // namespace sonoskin::ui
