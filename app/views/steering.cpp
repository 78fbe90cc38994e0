#include "app/views/steering.h"

#include <algorithm>
#include <cmath>

#include "app/widgets/theme.h"
#include "app/workspace/cursor_steps.h"

namespace sonoskin::ui {
namespace {

void turnWheel(ViewState& view, SlicePlane plane, const Geometry& geometry, double& turns,
               const PaneInput& pane) {
  SlicePose& pose = poseOf(view, plane);
  if (!pane.control) {
    turns += double(pane.wheel);
    const double whole = std::trunc(turns);
    turns -= whole;
    if (plane)
      stepCursor(view, geometry, *plane, {0, 0, int(whole)});
    else
      stepOblique(view, geometry, {0, 0, whole});
    return;
  }
  // The point under the mouse stays where it is.
  const glm::dvec2 fromMiddle = glm::dvec2(pane.mouse) - 0.5 * glm::dvec2(pane.size);
  const double before = frameOf(view, plane, geometry, pane).millimetresPerPixel();
  pose.zoom = std::clamp(pose.zoom * std::pow(1.15, double(pane.wheel)), 0.25, 40.0);
  const double after = frameOf(view, plane, geometry, pane).millimetresPerPixel();
  pose.pan += fromMiddle * (after - before);
  if (view.linkedZoom && !view.maximised) view.linkedScale = after;
}

}  // namespace

SlicePose& poseOf(ViewState& view, SlicePlane plane) {
  return plane ? view.slices[std::size_t(*plane)] : view.oblique.pose;
}

const SlicePose& poseOf(const ViewState& view, SlicePlane plane) {
  return plane ? view.slices[std::size_t(*plane)] : view.oblique.pose;
}

SliceCamera cameraOf(const ViewState& view, SlicePlane plane) {
  const SlicePose& pose = poseOf(view, plane);
  SliceCamera camera{plane.value_or(Plane::axial), view.cursor, pose.pan, pose.zoom, view.planes};
  if (!plane) camera.oblique = view.oblique.directions;
  return camera;
}

SliceFrame frameOf(const ViewState& view, SlicePlane plane, const Geometry& geometry, const PaneInput& pane) {
  return sliceFrame(geometry, cameraOf(view, plane), glm::ivec2(pane.size));
}

void steerSlice(ViewState& view, SlicePlane plane, const Geometry& geometry, double& turns,
                const PaneInput& pane) {
  if (pane.wheel != 0) turnWheel(view, plane, geometry, turns, pane);
  if (pane.button < 0) return;
  const SliceFrame frame = frameOf(view, plane, geometry, pane);
  const glm::vec2 moved = pane.moved / unit();
  if (pane.button == ImGuiMouseButton_Right) {
    view.grey.width = std::clamp(view.grey.width + moved.x * 0.004f, 0.02f, 2.0f);
    view.grey.level = std::clamp(view.grey.level + moved.y * 0.003f, 0.0f, 1.0f);
  } else if (pane.button == ImGuiMouseButton_Middle || pane.shift) {
    poseOf(view, plane).pan += glm::dvec2(pane.moved) * frame.millimetresPerPixel();
  } else {
    const glm::dvec3 at = frame.toWorld(glm::dvec2(pane.mouse));
    view.cursor = plane ? onVoxel(geometry, at) : inVolume(geometry, at);  // the plane stays where it is
  }
}

void linkZoom(ViewState& view, SlicePlane plane, const Geometry& geometry, const PaneInput& pane) {
  if (!view.linkedZoom || view.maximised) {
    view.linkedScale = 0;
    return;
  }
  const double now = frameOf(view, plane, geometry, pane).millimetresPerPixel();
  if (view.linkedScale == 0 && view.pointedAt == plane) view.linkedScale = now;
  if (view.linkedScale > 0) poseOf(view, plane).zoom *= now / view.linkedScale;
}

bool steer(Camera& camera, const PaneInput& pane) {
  constexpr float kRadiansPerPixel = 0.008f, kZoomPerPixel = 1.006f, kZoomPerNotch = 1.12f;
  const glm::vec2 moved = pane.moved / unit();
  bool changed = false;
  if (pane.button >= 0 && pane.moved != glm::vec2(0)) {
    changed = true;
    if (pane.button == ImGuiMouseButton_Middle || (pane.button == ImGuiMouseButton_Left && pane.shift)) {
      camera.pan({pane.moved.x, -pane.moved.y}, static_cast<int>(pane.size.y));
    } else if (pane.button == ImGuiMouseButton_Left) {
      camera.orbit(-moved.x * kRadiansPerPixel, moved.y * kRadiansPerPixel);
    } else {
      camera.zoom(std::pow(kZoomPerPixel, -moved.y));
    }
  }
  if (pane.wheel != 0) {
    changed = true;
    camera.zoom(std::pow(kZoomPerNotch, pane.wheel));
  }
  return changed;
}

}  // namespace sonoskin::ui
