#include "app/views/slice_tools.h"

#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

constexpr float kReach = 5;  // from a side of the box to the mouse that takes it
const ImU32 kErase = IM_COL32(240, 90, 110, 255), kBringBack = IM_COL32(120, 220, 140, 255);

// BoxInSlice: the crop box in pixels; nothing of it where the slice misses it.
struct BoxInSlice {
  glm::dvec2 upperLeft, lowerRight;
  bool seen = false;
};

BoxInSlice boxInSlice(const Workspace& w, Plane plane, const SliceFrame& frame) {
  const Geometry& g = w.session.scan().volume->geometry;
  const auto [low, high] = boxCorners(w.session.parameters().region, g);
  const int across = axisAcross(plane);
  const double at = g.toIndex(w.view.cursor)[across];
  return {frame.toPixel(low), frame.toPixel(high),
          at >= g.toIndex(low)[across] && at <= g.toIndex(high)[across]};
}

Grip gripUnderMouse(const Workspace& w, Plane plane, const SliceFrame& frame, const PaneInput& pane) {
  const BoxInSlice box = boxInSlice(w, plane, frame);
  if (!w.view.cropBox || w.view.erasing || !box.seen) return {};
  return gripAt(box.upperLeft, box.lowerRight, glm::dvec2(pane.mouse), double(kReach * unit()));
}

bool holdsLeft(const PaneInput& pane) { return pane.button == ImGuiMouseButton_Left; }

void eraseAtMouse(SliceTools& tools, Workspace& w, const SliceFrame& frame, const PaneInput& pane) {
  const glm::dvec3 at = frame.toWorld(glm::dvec2(pane.mouse));
  if (!tools.erasing) tools.brushAt = at;
  if (tools.erasing && pane.moved == glm::vec2(0)) return;
  w.session.erase({tools.brushAt, at, w.view.brushRadius, !(pane.control || pane.shift)});
  tools.brushAt = at;
  tools.erasing = true;
}

// A side lies half a voxel beyond the voxels that it keeps.
void dragSides(const Grip& grip, Workspace& w, Plane plane, const SliceFrame& frame, const PaneInput& pane) {
  const Geometry& g = w.session.scan().volume->geometry;
  const glm::dvec3 at = g.toIndex(frame.toWorld(glm::dvec2(pane.mouse)));
  Parameters parameters = w.session.parameters();
  const auto move = [&](int edge, int axis) {
    if (edge == 0) return;
    moveSide({axis, edge > 0}, (at[axis] - 0.5 * edge) * g.spacing[axis], parameters.region, g);
  };
  move(grip.right, axisRight(plane));
  move(grip.down, axisDown(plane));
  if (parameters.region.cutLow != w.session.parameters().region.cutLow ||
      parameters.region.cutHigh != w.session.parameters().region.cutHigh)
    w.session.edit(parameters);
}

}  // namespace

PaneInput useSliceTools(SliceTools& tools, Workspace& w, Plane plane, const SliceFrame& frame,
                        const PaneInput& pane) {
  PaneInput left = pane;
  const bool held = holdsLeft(pane);
  if (!held && (tools.grip || tools.erasing)) {
    w.session.commitEdit();
    tools = {};
    w.view.toolHeld = false;
  }
  if (!held) return left;
  if (w.view.erasing && (pane.pressed || tools.erasing)) {
    eraseAtMouse(tools, w, frame, pane);
  } else if (pane.pressed && !pane.shift) {
    tools.grip = gripUnderMouse(w, plane, frame, pane);
  } else if (tools.grip) {
    dragSides(tools.grip, w, plane, frame, pane);
  }
  if (tools.erasing || tools.grip) w.view.toolHeld = true;
  if (w.view.erasing || tools.grip) left.button = -1;
  return left;
}

void drawSliceTools(const SliceTools& tools, const Workspace& w, Plane plane, const SliceFrame& frame,
                    const PaneInput& pane) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float u = unit();
  if (w.view.erasing && (pane.hovered || tools.erasing)) {
    const ImVec2 middle{pane.corner.x + pane.mouse.x, pane.corner.y + pane.mouse.y};
    const float radius = static_cast<float>(w.view.brushRadius / frame.millimetresPerPixel());
    list.AddCircle(middle, radius, pane.control || pane.shift ? kBringBack : kErase, 0, 1.5f * u);
  }
  const Grip grip = tools.grip ? tools.grip : pane.hovered ? gripUnderMouse(w, plane, frame, pane) : Grip{};
  if (!grip) return;
  const BoxInSlice box = boxInSlice(w, plane, frame);
  const glm::vec2 a = pane.corner + glm::vec2(box.upperLeft), b = pane.corner + glm::vec2(box.lowerRight);
  const float x = grip.right < 0 ? a.x : b.x, y = grip.down < 0 ? a.y : b.y;
  const ImU32 colour = ImGui::GetColorU32(kAccent);
  if (grip.right != 0) list.AddLine({x, a.y}, {x, b.y}, colour, 3 * u);
  if (grip.down != 0) list.AddLine({a.x, y}, {b.x, y}, colour, 3 * u);
  const bool both = grip.right != 0 && grip.down != 0;
  const bool falling = grip.right == grip.down;
  ImGui::SetMouseCursor(both ? falling ? ImGuiMouseCursor_ResizeNWSE : ImGuiMouseCursor_ResizeNESW
                        : grip.right != 0 ? ImGuiMouseCursor_ResizeEW
                                          : ImGuiMouseCursor_ResizeNS);
}

}  // namespace sonoskin::ui
