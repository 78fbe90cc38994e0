#include "app/views/tools.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

constexpr float kReach = 5;  // from a side of the box to the mouse that takes it

// BoxInSlice: the crop box in pixels; nothing of it where the slice misses it.
struct BoxInSlice {
  glm::dvec2 upperLeft, lowerRight;
  bool seen = false;
};

BoxInSlice boxInSlice(const Workspace& w, const ToolPane::Slice& slice) {
  const Geometry& g = w.session.scan().volume->geometry;
  const auto [low, high] = boxCorners(w.session.parameters().region, g);
  if (!slice.plane) return {};
  const int across = w.view.planes[*slice.plane].across;
  const double at = g.toIndex(w.view.cursor)[across];
  const glm::dvec2 a = slice.frame.toPixel(low), b = slice.frame.toPixel(high);
  return {glm::min(a, b), glm::max(a, b), at >= g.toIndex(low)[across] && at <= g.toIndex(high)[across]};
}

Grip gripUnderMouse(const Workspace& w, const ToolPane& pane) {
  const BoxInSlice box = boxInSlice(w, *pane.slice);
  if (!box.seen) return {};
  return gripAt(box.upperLeft, box.lowerRight, glm::dvec2(pane.input.mouse), double(kReach * unit()));
}

// A side lies half a voxel beyond the voxels that it keeps.
void dragSides(const Grip& grip, Workspace& w, const ToolPane& pane) {
  const auto& [plane, frame] = *pane.slice;
  const Geometry& g = w.session.scan().volume->geometry;
  const glm::dvec3 at = g.toIndex(frame.toWorld(glm::dvec2(pane.input.mouse)));
  Parameters parameters = w.session.parameters();
  // An axis may run to the left, or upward.
  const auto move = [&](int edge, int axis, bool grows) {
    if (edge == 0) return;
    const int end = grows ? edge : -edge;
    moveSide({axis, end > 0}, (at[axis] - 0.5 * end) * g.spacing[axis], parameters.region, g);
  };
  const SliceAxes& axes = w.view.planes[*plane];
  move(grip.right, axes.right, axes.rightGrows);
  move(grip.down, axes.down, axes.downGrows);
  if (parameters.region.cutLow != w.session.parameters().region.cutLow ||
      parameters.region.cutHigh != w.session.parameters().region.cutHigh)
    w.session.edit(parameters);
}

void showCursor(const Grip& grip) {
  const bool both = grip.right != 0 && grip.down != 0;
  const bool falling = grip.right == grip.down;
  ImGui::SetMouseCursor(both ? falling ? ImGuiMouseCursor_ResizeNWSE : ImGuiMouseCursor_ResizeNESW
                        : grip.right != 0 ? ImGuiMouseCursor_ResizeEW
                                          : ImGuiMouseCursor_ResizeNS);
}

}  // namespace

PaneInput useCropBoxTool(ToolState& state, Workspace& w, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  if (state.held) {
    dragSides(state.grip, w, pane);
  } else if (holdsLeft(input) && input.pressed && !input.shift) {
    state.grip = gripUnderMouse(w, pane);
    if (state.grip) state.held = Tool::cropBox;
  }
  return state.held ? withoutButton(input) : input;
}

void letGoCropBoxTool(ToolState&, Workspace& w, const ToolPane&) { w.session.commitEdit(); }

void drawCropBoxTool(const ToolState& state, const Workspace& w, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  const Grip grip = state.held ? state.grip : input.hovered ? gripUnderMouse(w, pane) : Grip{};
  if (!grip) return;
  const BoxInSlice box = boxInSlice(w, *pane.slice);
  const glm::vec2 a = input.corner + glm::vec2(box.upperLeft), b = input.corner + glm::vec2(box.lowerRight);
  const float x = grip.right < 0 ? a.x : b.x, y = grip.down < 0 ? a.y : b.y;
  const ImU32 colour = ImGui::GetColorU32(kAccent);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (grip.right != 0) list.AddLine({x, a.y}, {x, b.y}, colour, 3 * unit());
  if (grip.down != 0) list.AddLine({a.x, y}, {b.x, y}, colour, 3 * unit());
  showCursor(grip);
}

}  // namespace sonoskin::ui
