#include "app/views/slice_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/texts/texts.h"
#include "app/views/edge_marks.h"
#include "app/views/steering.h"
#include "app/views/use_tool.h"
#include "app/widgets/theme.h"
#include "core/pipeline/parameter_key.h"

namespace sonoskin::ui {
namespace {

ImVec4 colourOf(Plane plane) {
  const std::array<ImVec4, 3> colours{kSagittal, kCoronal, kAxial};
  return colours[std::size_t(plane)];
}

bool marksVoxels(const Workspace& w) {
  return w.view.surfaceVoxels && w.view.layer != SliceLayer::thinned && w.session.results().thinned;
}

Key pictureKey(const Workspace& w, Plane plane, glm::ivec2 size) {
  const ViewState& v = w.view;
  const SlicePose& pose = v.slices[std::size_t(plane)];
  Hasher hasher("slice");
  hasher.add(plane).add(size.x).add(size.y).add(v.layer).add(v.grey.level).add(v.grey.width);
  hasher.add(pose.pan.x).add(pose.pan.y).add(pose.zoom);
  for (const SliceAxes& axes : v.planes.byPlane)
    hasher.add(axes.across).add(axes.right).add(axes.down).add(axes.rightGrows).add(axes.downGrows);
  hasher.add(v.cursor.x).add(v.cursor.y).add(v.cursor.z);
  hasher.add(marksVoxels(w)).add(v.cropBox).add(w.session.erased().key());
  addOptions(hasher, w.session.parameters().region);
  return hasher.key();
}

// Whether a slider was answered in the slice itself before the volume is classified.
bool isAnswered(const Workspace& w, Plane plane) {
  const int axis = w.view.planes[plane].across;
  const auto& slice = w.session.results().slices[std::size_t(axis)];
  return slice && std::abs(slice->geometry.toIndex(w.view.cursor)[axis]) < 0.5;
}

// The volume that the layer names; the raw one until the other is there.
const GpuVolume& shownVolume(GpuScans& scans, const Workspace& w, SliceLayer layer, Plane plane) {
  const Results& results = w.session.results();
  if (layer == SliceLayer::classified && isAnswered(w, plane)) {
    GpuVolume& slice = scans.slices[std::size_t(w.view.planes[plane].across)];
    slice.set(results.slices[std::size_t(w.view.planes[plane].across)]);
    return slice;
  }
  if (layer == SliceLayer::classified && results.classified) {
    scans.classified.set(results.classified);
    return scans.classified;
  }
  if (layer == SliceLayer::thinned && results.thinned) {
    scans.thinned.set(results.thinned);
    return scans.thinned;
  }
  scans.raw.set(w.session.scan().volume);
  return scans.raw;
}

void redraw(SliceWindow& window, Plane plane, SliceView& view, GpuScans& scans, const Workspace& w) {
  SliceViewInput input{.frame = w.session.scan().volume->geometry,
                       .camera = cameraOf(w.view, plane),
                       .volume = shownVolume(scans, w, w.view.layer, plane)};
  if (w.view.layer == SliceLayer::raw) input.window = w.view.grey;
  if (marksVoxels(w)) {
    input.overlay = &shownVolume(scans, w, SliceLayer::thinned, plane);
    input.overlayWindow = {0.25f, 0.5f};  // weak voxels are marked as well as strong ones
    input.overlayOpacity = 0.85f;
  }
  if (w.session.erased().voxels() > 0) {
    scans.erased.set(w.session.erased().mask(), w.session.erased().key());
    input.erased = &scans.erased;
  }
  if (w.view.cropBox) input.box = boxCorners(w.session.parameters().region, input.frame);
  view.draw(input, window.picture);
}

// Draws the picture anew where what it shows has changed. One that fails is not tried again until then.
void refresh(SliceWindow& window, Plane plane, std::optional<SliceView>& view, GpuScans& scans, Workspace& w,
             glm::ivec2 size) {
  if (w.view.catchingUp || !scans.ready) return;
  const Results& results = w.session.results();
  const bool others = window.from.see({w.session.scan().volume, results.classified, results.thinned,
                                       results.slices[std::size_t(w.view.planes[plane].across)]});
  const Key key = pictureKey(w, plane, size);
  if (!others && key == window.drawn) return;
  window.drawn = key;
  const std::string failure = failureOf([&] {
    if (!view) view.emplace();
    if (!window.picture) window.picture = gl::Framebuffer({.size = size});
    window.picture.fit(size);
    redraw(window, plane, *view, scans, w);
  });
  if (failure.empty()) return;
  window.picture = {};
  w.toasts.add(failure, true);
}

// Where the slice lies: counted along its axis, and where that is in the world or from the probe.
std::string placeText(const Workspace& w, const ViewFrame& frame, Plane plane) {
  const Geometry& g = w.session.scan().volume->geometry;
  const SliceAxes& axes = w.view.planes[plane];
  const int slice = static_cast<int>(std::lround(g.toIndex(w.view.cursor)[axes.across])) + 1;
  const int last = g.dims[axes.across];
  const std::string count =
      fmt::format(fmt::runtime(tr("{} of {}")), axes.acrossGrows ? slice : last + 1 - slice, last);
  if (!frame.isPatient) {
    const int before = (axes.acrossGrows ? slice : last + 1 - slice) - 1;
    return fmt::format("{}   {:.1f} mm", count, double(before) * g.spacing[axes.across]);
  }
  const double at = w.view.cursor[int(plane)];
  return fmt::format("{}   {} {:.1f} mm", count, "RLAPIS"[2 * int(plane) + (at > 0 ? 1 : 0)], std::abs(at));
}

void drawMarks(const PaneInput& pane, const Workspace& w, Plane plane) {
  const Geometry& g = w.session.scan().volume->geometry;
  const ViewFrame frame = w.viewFrame();
  const bool coarse =
      w.view.layer == SliceLayer::classified && w.session.classifiedIsCoarse() && !isAnswered(w, plane);
  drawEdges(pane, frame, frameOf(w.view, plane, g, pane));
  paneTitle(pane, tr(planeName(frame, plane)), colourOf(plane),
            placeText(w, frame, plane) + (coarse ? std::string("   ") + tr("coarse") : ""));
  scaleBar(pane, 1 / frameOf(w.view, plane, g, pane).millimetresPerPixel());
}

}  // namespace

void drawSliceWindow(SliceWindow& window, Plane plane, std::optional<SliceView>& view, GpuScans& scans,
                     Workspace& workspace, const PaneInput& pane) {
  if (!workspace.session.hasScan()) {
    paneTitle(pane, tr(planeName({}, plane)), colourOf(plane), "");
    return;
  }
  const Geometry& geometry = workspace.session.scan().volume->geometry;
  const auto seen = [&] {
    return ToolPane{pane, ToolPane::Slice{plane, frameOf(workspace.view, plane, geometry, pane)}};
  };
  useTool(window.tools, workspace, seen());
  refresh(window, plane, view, scans, workspace, glm::max(glm::ivec2(pane.size), glm::ivec2(1)));
  showTexture(pane, window.picture);
  drawTool(window.tools, workspace, seen());
  drawMarks(pane, workspace, plane);
}

}  // namespace sonoskin::ui
