#pragma once

#include "app/workspace/view_state.h"

namespace sonoskin {

struct Workspace;

// isInSlices: whether slices show a layer, alone or over another.
bool isInSlices(const Workspace& workspace, SliceLayer layer);

}  // namespace sonoskin
