#pragma once

#include "app/views/pane.h"
#include "render/slice_frame.h"

namespace sonoskin::ui {

// drawEdges: what lies beyond each edge of a slice's picture: R, L, A, P, S, I, or where the probe and the top of a scanner's
// frame are; see edgeText.
void drawEdges(const PaneInput& pane, const ViewFrame& frame, const SliceFrame& slice);

}  // namespace sonoskin::ui
