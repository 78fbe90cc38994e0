#include "app/views/space_picture.h"

#include <algorithm>
#include <cmath>

#include "core/pipeline/parameter_key.h"

namespace sonoskin::ui {
namespace {

using Sampling = PictureState::Sampling;

constexpr double kMovingBudget = 0.045, kRestingBudget = 2, kSmoothBudget = 0.6;  // seconds for one picture
constexpr double kMovingLeast = 0.25, kRestingLeast = 0.6;  // share of the pixels along a side

// The objects that the picture is drawn from.
ObjectsSeen<2>::Objects drawnFrom(const Workspace& w) {
  const Results& results = w.session.results();
  if (showsMesh(w)) return {results.mesh, showsParts(w) ? results.verdicts : nullptr};
  return {shownVolume(w), results.points};
}

// The fingerprint of everything else that it depends on.
Key pictureKey(const SpaceWindow& window, const Workspace& w, glm::ivec2 size) {
  const ViewState& v = w.view;
  Hasher hasher("3D");
  hasher.addBytes(&v.camera.target, sizeof v.camera.target)
      .addBytes(&v.camera.forward, sizeof v.camera.forward);
  hasher.addBytes(&v.camera.up, sizeof v.camera.up).add(v.camera.distance).add(v.camera.fieldOfView);
  hasher.add(size.x).add(size.y).add(v.content).add(v.volumeStyle).add(v.meshStyle).add(v.unmeasured);
  if (showsMesh(w)) {
    hasher.add(showsParts(w));
    if (wantsSkin(w)) window.skin.addTo(hasher, w);
  } else {
    hasher.add(shownLevel(v, w.session.results())).add(v.volumeLayer).add(v.crop);
    addOptions(hasher, w.session.parameters().region);
    hasher.add(w.session.scan().erasedKey);  // as the points have it: a stroke is faster than this view
  }
  return hasher.key();
}

bool showsSkin(const SpaceWindow& window, const Workspace& w) { return wantsSkin(w) && window.skin.shows(w); }

LightState shownLight(const SpaceWindow& window, const Workspace& w) {
  return showsSkin(window, w) ? window.skin.light() : LightState::refined;
}

void drawMesh(SpaceWindow& window, const Workspace& w, int supersampling, const gl::Target& target) {
  if (!window.meshView) window.meshView.emplace();
  const MeshScene scene = meshScene(window.parts, w);
  window.mesh.set(scene.mesh);
  window.meshView->draw(meshInput(scene, window.mesh, w.view.camera, supersampling), target);
}

void drawVolume(SpaceWindow& window, GpuScans& scans, const Workspace& w, int raysPerPixel,
                const gl::Target& target) {
  if (!window.raycaster) window.raycaster.emplace();
  const VolumeScene scene = volumeScene(w);
  GpuVolume& copy = scene.volume == w.session.scan().volume ? scans.raw : scans.classified;
  copy.set(scene.volume);
  const ErasedParts& erased = w.session.erased();
  const bool some = erased.voxels() > 0;
  if (some) scans.erased.set(erased.mask(), erased.key());
  window.raycaster->draw(
      raycastInput(scene, copy, some ? &scans.erased : nullptr, w.view.camera, raysPerPixel), target);
}

// Samples: along each side of a pixel; more than one smooth the edges.
void drawScene(SpaceWindow& window, GpuScans& scans, const Workspace& w, int samples,
               const gl::Target& target) {
  if (showsSkin(window, w)) {
    window.skin.draw(w, samples, target);
    if (window.skin.light() == LightState::none) drawMesh(window, w, samples, target);
  } else if (showsMesh(w)) {
    drawMesh(window, w, samples, target);
  } else {
    drawVolume(window, scans, w, samples, target);
  }
}

// How many pixels the picture gets, so that it is ready within the budget.
glm::ivec2 pictureSize(const SpaceWindow& window, glm::vec2 size) {
  const bool moving = window.state.moving;
  const double affordable = (moving ? kMovingBudget : kRestingBudget) / window.secondsPerPixel;
  const double share =
      std::clamp(std::sqrt(affordable / double(size.x * size.y)), moving ? kMovingLeast : kRestingLeast, 1.0);
  return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * share)), glm::ivec2(16));
}

// Whether a surface that rests can have four samples per pixel, so that its outline is no staircase. Skin waits for its
// finished light.
bool affordsSmoothing(const SpaceWindow& window, const Workspace& w, glm::ivec2 size) {
  if (window.state.light < LightState::refined) return false;
  return showsMesh(w) && 4 * window.secondsPerPixel * double(size.x) * double(size.y) < kSmoothBudget;
}

void redraw(SpaceWindow& window, GpuScans& scans, const Workspace& w, glm::ivec2 size, int samples) {
  if (!window.timer) window.timer.emplace();
  if (!window.picture) {
    window.picture = gl::Framebuffer({.size = size, .filter = gl::Filter::linear});
  }
  window.picture.fit(size);
  const bool lighting = window.state.lighting();
  window.timer->begin();
  drawScene(window, scans, w, samples, window.picture);
  window.timer->end();
  window.state.light = shownLight(window, w);
  if (samples > 1 || lighting || window.state.lighting()) return;
  const double perPixel = window.timer->seconds() / (double(size.x) * size.y);
  // Small pictures cost more per pixel: follow a rise at once, a fall slowly.
  window.secondsPerPixel = std::max(perPixel, 0.7 * window.secondsPerPixel + 0.3 * perPixel);
  window.secondsPerPixel = std::clamp(window.secondsPerPixel, 1e-9, 1e-4);
}

// Draws the picture anew where what it shows has changed, or while the skin's light is on its way.
void refresh(SpaceWindow& window, GpuScans& scans, Workspace& workspace, glm::ivec2 whole) {
  PictureState& state = window.state;
  if (window.from.see(drawnFrom(workspace))) window.drawn = window.failed = {};
  const Key key = pictureKey(window, workspace, whole);
  if (window.failed == key) return;  // not again until something changes
  if (window.drawn != key) state.sampling = Sampling::none;
  const glm::ivec2 size = pictureSize(window, glm::vec2(whole));
  // Edges are smoothed when the full picture is there.
  const bool smoothly =
      !state.moving && state.sampling == Sampling::full && affordsSmoothing(window, workspace, whole);
  const Sampling wanted = smoothly ? Sampling::smooth : state.moving ? Sampling::draft : Sampling::full;
  if (!state.lighting() && state.sampling >= wanted) return;
  const std::string failure = failureOf([&] { redraw(window, scans, workspace, size, smoothly ? 2 : 1); });
  if (!failure.empty()) {
    window.picture = {};
    window.failed = key;
    workspace.toasts.add(failure, true);
    return;
  }
  window.drawn = key;
  // A draft that has all pixels is the full picture.
  state.sampling = wanted == Sampling::draft && size == whole ? Sampling::full : wanted;
  if (!smoothly && showsSkin(window, workspace))
    window.skin.note(workspace, double(size.x) * size.y / (double(whole.x) * whole.y));
}

}  // namespace

void advancePicture(SpaceWindow& window, GpuScans& scans, Workspace& workspace, glm::ivec2 whole) {
  PictureState& state = window.state;
  state.light = shownLight(window, workspace);
  const bool lighting = state.lighting(), late = workspace.view.catchingUp || !scans.ready;
  state.moving |= lighting;
  if (!late) refresh(window, scans, workspace, whole);
  state.unfinished = lighting || state.lighting();
  if (wantsSkin(workspace) && !late) {
    for (const std::string& failure : window.skin.refine(workspace, !state.moving))
      workspace.toasts.add(failure, true);
    state.light = shownLight(window, workspace);
  }
  const bool rough = state.sampling == Sampling::full && affordsSmoothing(window, workspace, whole);
  state.unfinished |= (late || rough) && !state.moving;
  workspace.view.skin.status.settled = showsSkin(window, workspace) && state.settled();
}

}  // namespace sonoskin::ui
