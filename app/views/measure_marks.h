#pragma once

#include <functional>
#include <optional>

#include "app/document/measures.h"
#include "app/views/pane.h"
#include "app/workspace/workspace.h"
#include "render/slice_frame.h"

namespace sonoskin::ui {

// isInSlice: whether a mark lies within half a slice of the plane that a frame shows.
bool isInSlice(const glm::dvec3& mark, const SliceFrame& frame, const Geometry& geometry);

// drawMeasuresInSlice: the measures whose marks all lie in the slice, with their values, and the one that is being set, up to
// the mouse. drawMeasuresInSpace: all of them, as the camera sees them.
void drawMeasuresInSlice(const PaneInput& pane, const Workspace& workspace, const SliceFrame& frame);
void drawMeasuresInSpace(const PaneInput& pane, const Workspace& workspace);

}  // namespace sonoskin::ui
