#pragma once

#include "app/views/pane.h"
#include "app/workspace/view_state.h"
#include "render/slice_frame.h"

namespace sonoskin::ui {

// poseOf: how a slice is seen. cameraOf: what part of a slice the view state names. frameOf: from the pixels of a pane that shows it to the world.
SlicePose& poseOf(ViewState& view, SlicePlane plane);
const SlicePose& poseOf(const ViewState& view, SlicePlane plane);
SliceCamera cameraOf(const ViewState& view, SlicePlane plane);
SliceFrame frameOf(const ViewState& view, SlicePlane plane, const Geometry& geometry, const PaneInput& pane);

// steerSlice: left moves the cross-hair, the wheel goes to the next slice, Ctrl+wheel zooms about the mouse, middle or
// Shift+left pans, right sets the grey window.
//   turns  of the wheel, not yet a whole slice
void steerSlice(ViewState& view, SlicePlane plane, const Geometry& geometry, double& turns,
                const PaneInput& pane);

// linkZoom: while all slices are zoomed together, brings one to as many mm per pixel as that which was zoomed last. Once a
// frame for each slice; one that is seen alone is as large as its view.
void linkZoom(ViewState& view, SlicePlane plane, const Geometry& geometry, const PaneInput& pane);

// steer: what a mouse does to a camera: left rotates, middle or Shift+left pans, right or wheel zooms.
//   output  whether the camera has changed
bool steer(Camera& camera, const PaneInput& pane);

}  // namespace sonoskin::ui
