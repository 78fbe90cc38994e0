#pragma once

#include "app/views/slice_window.h"

namespace sonoskin::ui {

// isAnswered: whether a slider was answered in the slice itself before the volume is classified.
bool isAnswered(const Workspace& workspace, SlicePlane plane);

// isThere: whether there is what a layer shows.
bool isThere(const Workspace& workspace, SliceLayer layer);

// refreshSlice: draws the picture anew where what it shows has changed. One that fails is not tried again until then.
void refreshSlice(SliceWindow& window, const ShownSlice& shown, std::optional<SliceView>& view,
                  GpuScans& scans, Workspace& workspace, glm::ivec2 size);

}  // namespace sonoskin::ui
