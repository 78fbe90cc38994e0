#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "app/views/double_click.h"
#include "app/views/slice_window.h"
#include "app/views/space_window.h"
#include "app/workspace/shown_pane.h"
#include "app/workspace/workspace.h"

namespace sonoskin::ui {

// FourUp: slices and the 3D view, with everything that they keep on the GPU.
struct FourUp {
  GpuScans scans;
  std::optional<SliceView> sliceView;
  std::array<SliceWindow, 3> slices;  // by Plane
  SliceWindow oblique;
  std::array<SliceWindow, 3> compared;  // by SliceLayer
  SpaceWindow space;
  std::unique_ptr<std::array<SpaceWindow, 3>> casts;  // by SliceLayer, while they are compared
  SharedTime time;                                    // of all that show 3D
  DoubleClick clicks;
  std::vector<ShownPane> shown;  // in the last frame
};

// drawFourUp: as Settings::layout has them, or the maximised one alone, in what is left of the current ImGui window.
//   output  seconds after which it wants a frame; negative for never
double drawFourUp(FourUp& views, Workspace& workspace);

}  // namespace sonoskin::ui
