#pragma once

#include <optional>

#include "app/views/mesh_contour.h"
#include "app/views/pane.h"
#include "app/views/space_window.h"
#include "app/views/tools.h"
#include "app/workspace/objects_seen.h"
#include "app/workspace/workspace.h"
#include "render/slice_view.h"

namespace sonoskin::ui {

// ShownSlice: what a slice view is of.
//   compared  with others: its layer alone, without anything over it
struct ShownSlice {
  SlicePlane plane = Plane::axial;
  SliceLayer layer = SliceLayer::raw;
  bool compared = false;
};

// SliceWindow: one slice. It keeps its picture and draws a new one only when what it shows has changed.
struct SliceWindow {
  gl::Framebuffer picture;
  Key drawn;  // of what the picture shows
  ObjectsSeen<4> from;
  MeshContour contour;
  ToolState tools;
};

// drawSliceWindow: the picture with its marks; turns what the mouse did into cross-hair, pan, zoom and
// window.
//   view  shared by all slices; made when first needed
void drawSliceWindow(SliceWindow& window, const ShownSlice& shown, std::optional<SliceView>& view,
                     GpuScans& scans, Workspace& workspace, const PaneInput& pane);

}  // namespace sonoskin::ui
