#pragma once

#include "app/views/slice_window.h"

namespace sonoskin::ui {

// drawOverlays: what lies over a slice's picture, each where it is switched on: the contour of the surface, and the points
// that lie in the slice.
void drawOverlays(SliceWindow& window, const Workspace& workspace, const SliceFrame& frame,
                  const PaneInput& pane);

// pointerText: where in the world the mouse is, and the value there: in the file and from 0 to 1; empty outside of the volume.
std::string pointerText(const Workspace& workspace, const SliceFrame& frame, const PaneInput& pane);

}  // namespace sonoskin::ui
