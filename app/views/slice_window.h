#pragma once

#include <optional>

#include "app/views/pane.h"
#include "app/views/slice_tools.h"
#include "app/views/space_window.h"
#include "app/workspace/objects_seen.h"
#include "app/workspace/workspace.h"
#include "render/slice_view.h"

namespace sonoskin::ui {

// SliceWindow: one slice. It keeps its picture and draws a new one only when what it shows has changed.
struct SliceWindow {
  gl::Framebuffer picture;
  Key drawn;  // of what the picture shows
  ObjectsSeen<3> from;
  double turns = 0;  // of the wheel, not yet a whole slice
  SliceTools tools;
};

// drawSliceWindow: the picture with its marks; turns what the mouse did into cross-hair, pan, zoom and
// window.
//   view  shared by the three slices; made when first needed
void drawSliceWindow(SliceWindow& window, Plane plane, std::optional<SliceView>& view, GpuScans& scans,
                     Workspace& workspace, const PaneInput& pane);

// steerSlice: left moves the cross-hair, the wheel goes to the next slice, Ctrl+wheel zooms about the mouse,
// middle or Shift+left pans, right sets the grey window.
void steerSlice(ViewState& view, Plane plane, const Geometry& geometry, double& turns, const PaneInput& pane);

}  // namespace sonoskin::ui
