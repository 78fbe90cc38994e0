#include "app/views/slice_picture.h"

#include <cmath>

#include "app/views/steering.h"
#include "core/pipeline/parameter_key.h"

namespace sonoskin::ui {
namespace {

bool marksVoxels(const Workspace& w, const ShownSlice& shown) {
  return !shown.compared && w.view.surfaceVoxels && shown.layer != SliceLayer::thinned &&
         w.session.results().thinned;
}

bool isTinted(const Workspace& w, const ShownSlice& shown) {
  return !shown.compared && w.view.classifiedTint && shown.layer == SliceLayer::raw &&
         isThere(w, SliceLayer::classified);
}

Key pictureKey(const Workspace& w, const ShownSlice& shown, glm::ivec2 size) {
  const ViewState& v = w.view;
  const SlicePose& pose = poseOf(v, shown.plane);
  Hasher hasher("slice");
  hasher.add(shown.plane ? int(*shown.plane) : -1)
      .add(size.x)
      .add(size.y)
      .add(shown.layer)
      .add(v.grey.level)
      .add(v.grey.width);
  hasher.add(pose.pan.x).add(pose.pan.y).add(pose.zoom);
  for (const SliceAxes& axes : v.planes.byPlane)
    hasher.add(axes.across).add(axes.right).add(axes.down).add(axes.rightGrows).add(axes.downGrows);
  if (!shown.plane)
    for (const glm::dvec3& along : {v.oblique.directions.right, v.oblique.directions.down})
      hasher.add(along.x).add(along.y).add(along.z);
  hasher.add(v.cursor.x).add(v.cursor.y).add(v.cursor.z);
  hasher.add(marksVoxels(w, shown)).add(isTinted(w, shown)).add(v.cropBox).add(w.session.erased().key());
  addOptions(hasher, w.session.parameters().region);
  return hasher.key();
}

// The volume that the layer names; the raw one until the other is there.
const GpuVolume& shownVolume(GpuScans& scans, const Workspace& w, const ShownSlice& shown) {
  const Results& results = w.session.results();
  if (shown.layer == SliceLayer::classified && isAnswered(w, shown.plane)) {
    const auto across = std::size_t(w.view.planes[*shown.plane].across);
    scans.slices[across].set(results.slices[across]);
    return scans.slices[across];
  }
  if (shown.layer == SliceLayer::classified && results.classified) {
    scans.classified.set(results.classified);
    return scans.classified;
  }
  if (shown.layer == SliceLayer::thinned && results.thinned) {
    scans.thinned.set(results.thinned);
    return scans.thinned;
  }
  scans.raw.set(w.session.scan().volume);
  return scans.raw;
}

void redraw(SliceWindow& window, const ShownSlice& shown, SliceView& view, GpuScans& scans,
            const Workspace& w) {
  SliceViewInput input{.frame = w.session.scan().volume->geometry,
                       .camera = cameraOf(w.view, shown.plane),
                       .volume = shownVolume(scans, w, shown)};
  if (shown.layer == SliceLayer::raw) input.window = w.view.grey;
  if (isTinted(w, shown)) {
    input.tint = &shownVolume(scans, w, {shown.plane, SliceLayer::classified});
    input.tintWindow = {0.5f, 0.8f};
  }
  if (marksVoxels(w, shown)) {
    input.overlay = &shownVolume(scans, w, {shown.plane, SliceLayer::thinned});
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

}  // namespace

bool isAnswered(const Workspace& w, SlicePlane plane) {
  if (!plane) return false;
  const int axis = w.view.planes[*plane].across;
  const auto& slice = w.session.results().slices[std::size_t(axis)];
  return slice && std::abs(slice->geometry.toIndex(w.view.cursor)[axis]) < 0.5;
}

bool isThere(const Workspace& w, SliceLayer layer) {
  const Results& results = w.session.results();
  if (layer == SliceLayer::classified) return results.classified != nullptr;
  return layer == SliceLayer::raw || results.thinned != nullptr;
}

void refreshSlice(SliceWindow& window, const ShownSlice& shown, std::optional<SliceView>& view,
                  GpuScans& scans, Workspace& w, glm::ivec2 size) {
  if (w.view.catchingUp || !scans.ready) return;
  const Results& results = w.session.results();
  const auto answer = shown.plane ? results.slices[std::size_t(w.view.planes[*shown.plane].across)] : nullptr;
  const bool others = window.from.see({w.session.scan().volume, results.classified, results.thinned, answer});
  const Key key = pictureKey(w, shown, size);
  if (!others && key == window.drawn) return;
  window.drawn = key;
  const std::string failure = failureOf([&] {
    if (!view) view.emplace();
    if (!window.picture) window.picture = gl::Framebuffer({.size = size});
    window.picture.fit(size);
    redraw(window, shown, *view, scans, w);
  });
  if (failure.empty()) return;
  window.picture = {};
  w.toasts.add(failure, true);
}

}  // namespace sonoskin::ui
