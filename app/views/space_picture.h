#pragma once

#include "app/views/space_window.h"

namespace sonoskin::ui {

// advancePicture: takes the picture of the 3D view as far as this frame can: a draft while something moves, all pixels when
// it rests, then smooth edges; of skin the next pass of its light, which is refined when it rests.
//   input    whole   the view's pixels
//            window  its `state` says whether camera or tools move
//   output   window's picture and state
void advancePicture(SpaceWindow& window, GpuScans& scans, Workspace& workspace, glm::ivec2 whole);

}  // namespace sonoskin::ui
