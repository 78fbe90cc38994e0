#pragma once

#include "app/document/crop_box.h"
#include "app/views/pane.h"
#include "app/workspace/workspace.h"
#include "render/slice_frame.h"

namespace sonoskin::ui {

// SliceTools: what the left button holds in one slice.
struct SliceTools {
  Grip grip;             // sides of the crop box
  bool erasing = false;  // a stroke is on its way
  glm::dvec3 brushAt{0};
};

// useSliceTools: the eraser, where it is on: left erases, with Ctrl or Shift it brings back; else the crop box, whose
// sides left drags.
//   output  the pane's input without what a tool has taken
PaneInput useSliceTools(SliceTools& tools, Workspace& workspace, Plane plane, const SliceFrame& frame,
                        const PaneInput& pane);

// drawSliceTools: the brush under the mouse, the sides of the box that it would hold.
void drawSliceTools(const SliceTools& tools, const Workspace& workspace, Plane plane, const SliceFrame& frame,
                    const PaneInput& pane);

}  // namespace sonoskin::ui
