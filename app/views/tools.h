#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/document/crop_box.h"
#include "app/views/pane.h"
#include "app/workspace/workspace.h"
#include "render/slice_frame.h"

namespace sonoskin::ui {

// The tools of the mouse, one file each; app/views/use_tool.h says which of them is used.

// ToolPane: a view as its tools see it.
//   input  what the mouse does there
//   slice  which slice it shows, and how; none in 3D
struct ToolPane {
  struct Slice {
    SlicePlane plane = Plane::axial;
    SliceFrame frame;
  };
  PaneInput input;
  std::optional<Slice> slice{};
};

// ToolState: what the tools of one view keep from one frame to the next.
struct ToolState {
  std::optional<Tool> held;  // has had the left button since it went down
  Grip grip;                 // of the crop box: the sides that are dragged
  glm::dvec3 brushAt{0};     // of the eraser: where it was, world mm
  // Of the parts: where the button went down and where it is, from the view's upper left corner, and whether Ctrl and
  // Shift were down.
  struct Stroke {
    glm::vec2 from{0}, to{0};
    bool control = false, shift = false;
  } stroke;
  // Of the lamp: from the mouse to the lamp, pixels; it may be the line between the halves that is held; whether the wheel
  // has changed the distance, which is not a step for undo yet.
  struct Lamp {
    glm::vec2 offset{0};
    bool divider = false, turning = false;
  } lamp;
  std::vector<glm::vec2> outline;  // of the lasso, from the view's upper left corner
  // Of measures: the mark that is dragged.
  struct Mark {
    std::size_t measure = 0, number = 0;
  };
  std::optional<Mark> mark;
  double turns = 0;  // of the wheel in a slice, not yet a whole slice
  // Of the crop box and the clip plane in 3D: the side that is dragged, and how far its place lay beyond the mouse, mm.
  struct Drag {
    Side side;
    double beyond = 0;
  } drag;
  double obliqueAt = 0;  // of the oblique plane's line: where the mouse was around the cross-hair, radians
};

// use...: one frame of a tool that can be used; those that keep the button set `held`.
//   output  what is left of the mouse
// letGo...: the button that it held has gone up, or the tool was put away with the button down.
// draw...: its own marks. What is shown with any tool is not drawn here.

// A click on the surface gives it the landmark.
PaneInput useLandmarkTool(ToolState& state, Workspace& workspace, const ToolPane& pane);

// Left erases, with Ctrl or Shift it brings back.
PaneInput useEraser(ToolState& state, Workspace& workspace, const ToolPane& pane);
void letGoEraser(ToolState& state, Workspace& workspace, const ToolPane& pane);
void drawEraser(const ToolState& state, const Workspace& workspace, const ToolPane& pane);

// Left draws an outline; when it is let go, what is seen within it is erased: with Ctrl it is brought back, with Shift all
// that is seen without it is erased.
PaneInput useLasso(ToolState& state, Workspace& workspace, const ToolPane& pane);
void letGoLasso(ToolState& state, Workspace& workspace, const ToolPane& pane);
void drawLasso(const ToolState& state, const Workspace& workspace, const ToolPane& pane);
// Clicks and drags set marks, or move those that are there.
PaneInput useMeasureTool(ToolState& state, Workspace& workspace, const ToolPane& pane);
void letGoMeasureTool(ToolState& state, Workspace& workspace, const ToolPane& pane);

// A click takes the part below the mouse away or brings it back, with Shift it leaves that part alone; a line drawn with
// Ctrl splits the part that it crosses.
PaneInput usePartTool(ToolState& state, Workspace& workspace, const ToolPane& pane);
void letGoPartTool(ToolState& state, Workspace& workspace, const ToolPane& pane);
void drawPartTool(const ToolState& state, const Workspace& workspace, const ToolPane& pane);
// partCaption: how many parts are shown. drawPartHints: what the mouse does.
std::string partCaption(const Workspace& workspace);
void drawPartHints(const PaneInput& pane);

// Moves the lamp or the line between the halves; the wheel changes the lamp's distance.
PaneInput useLampTool(ToolState& state, Workspace& workspace, const ToolPane& pane);
void letGoLampTool(ToolState& state, Workspace& workspace, const ToolPane& pane);

// Left drags the sides of the crop box.
PaneInput useCropBoxTool(ToolState& state, Workspace& workspace, const ToolPane& pane);
void letGoCropBoxTool(ToolState& state, Workspace& workspace, const ToolPane& pane);
void drawCropBoxTool(const ToolState& state, const Workspace& workspace, const ToolPane& pane);

// Left turns the oblique plane about the cross-hair, where it takes an end of the plane's line in another slice.
PaneInput useObliqueTool(ToolState& state, Workspace& workspace, const ToolPane& pane);

// In 3D, left drags the handle in the middle of a side of the crop box, or that of the clip plane, along its normal.
PaneInput useCropFaces(ToolState& state, Workspace& workspace, const ToolPane& pane);
PaneInput useClipTool(ToolState& state, Workspace& workspace, const ToolPane& pane);

}  // namespace sonoskin::ui
