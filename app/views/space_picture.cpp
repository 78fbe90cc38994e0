#include "app/views/space_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/pipeline/parameter_key.h"

namespace sonoskin::ui {
namespace {

using Sampling = PictureState::Sampling;

constexpr double kBandSeconds = 0.05;                       // for a part of the rows of a volume that rests
constexpr double kRestingBudget = 2, kSmoothBudget = 0.6;   // seconds for one picture
constexpr double kMovingLeast = 0.25, kRestingLeast = 0.6;  // share of the pixels along a side

bool showsMesh(const SpaceWindow& window, const Workspace& w) { return !window.compared && ui::showsMesh(w); }

VolumeScene sceneOf(const SpaceWindow& window, const Workspace& w) {
  return window.compared ? comparedScene(w, *window.compared) : volumeScene(w);
}

// The objects that the picture is drawn from.
ObjectsSeen<3>::Objects drawnFrom(const SpaceWindow& window, const Workspace& w) {
  const Results& results = w.session.results();
  if (window.compared) {
    const VolumeScene scene = comparedScene(w, *window.compared);
    return {scene.volume, scene.bytes, results.points};
  }
  if (ui::showsMesh(w)) return {results.mesh, showsParts(w) ? results.verdicts : nullptr};
  return {shownVolume(w), results.points, w.view.volume.mesh ? results.mesh : nullptr};
}

void addVolume(Hasher& hasher, const SpaceWindow& window, const Workspace& w) {
  const ViewState& v = w.view;
  const VolumeScene scene = sceneOf(window, w);
  hasher.add(scene.level).add(scene.look).add(v.volumeLayer).add(v.crop);
  addOptions(hasher, w.session.parameters().region);
  hasher.add(w.session.scan().erasedKey);  // as the points have it: a stroke is faster than this view
  if (scene.look == VolumeLook::maximum) hasher.add(v.grey.level).add(v.grey.width);
  if (scene.look != VolumeLook::translucent) return;
  hasher.add(v.volume.shadows).add(v.volume.mesh);
  for (const auto& p : scene.transfer.points) {
    const std::array numbers{p.value, p.opacity, p.colour.r, p.colour.g, p.colour.b};
    hasher.add(std::span<const float>(numbers));
  }
}

// The fingerprint of everything else that it depends on.
Key pictureKey(const SpaceWindow& window, const Workspace& w, glm::ivec2 size) {
  const ViewState& v = w.view;
  Hasher hasher("3D");
  hasher.addBytes(&v.camera.target, sizeof v.camera.target)
      .addBytes(&v.camera.forward, sizeof v.camera.forward);
  hasher.addBytes(&v.camera.up, sizeof v.camera.up).add(v.camera.distance).add(v.camera.fieldOfView);
  hasher.add(size.x).add(size.y).add(v.content).add(v.volumeStyle).add(v.meshStyle).add(v.unmeasured);
  const glm::vec4 clip = clipOf(w).equation();
  hasher.addBytes(&clip, sizeof clip);
  if (showsMesh(window, w)) {
    hasher.add(showsParts(w));
    if (wantsSkin(w)) window.skin.addTo(hasher, w);
  } else {
    addVolume(hasher, window, w);
  }
  return hasher.key();
}

bool showsSkin(const SpaceWindow& window, const Workspace& w) {
  return !window.compared && wantsSkin(w) && window.skin.shows(w);
}

LightState shownLight(const SpaceWindow& window, const Workspace& w) {
  return showsSkin(window, w) ? window.skin.light() : LightState::refined;
}

void drawMesh(SpaceWindow& window, const Workspace& w, int supersampling, const gl::Target& target) {
  if (!window.meshView) window.meshView.emplace();
  const MeshScene scene = meshScene(window.parts, w);
  window.mesh.set(scene.mesh);
  window.meshView->draw(meshInput(scene, window.mesh, w.view.camera, supersampling), target);
}

// Sketch: a picture that is drawn, or a part of it.
//   samples  along each side of a pixel; more than one smooth the edges
//   rows     see RaycastInput
struct Sketch {
  glm::ivec2 size{0};
  int samples = 1;
  glm::vec2 rows{0, 1};
};

// The surface within a translucent volume, as large as the picture.
SurfaceBehind drawBehind(SpaceWindow& window, const VolumeScene& scene, const Camera& camera,
                         const Sketch& sketch) {
  if (sketch.rows.x > 0) return {window.meshView->buffer(), window.behind};
  if (!window.meshView) window.meshView.emplace();
  const glm::ivec2 size = sketch.size;
  if (!window.behind) window.behind = gl::Framebuffer({.size = size});
  window.behind.fit(size);
  window.mesh.set(scene.mesh);
  window.meshView->draw(meshInput(meshWithin(scene), window.mesh, camera, 1), window.behind);
  return {window.meshView->buffer(), window.behind};
}

GpuVolume& copyOf(GpuScans& scans, const VolumeScene& scene, const Workspace& w) {
  GpuVolume& copy = scene.bytes                               ? scans.thinned
                    : scene.volume == w.session.scan().volume ? scans.raw
                                                              : scans.classified;
  if (scene.bytes)
    copy.set(scene.bytes);
  else
    copy.set(scene.volume);
  return copy;
}

void drawVolume(SpaceWindow& window, GpuScans& scans, const Workspace& w, const Sketch& sketch) {
  if (!window.raycaster) window.raycaster.emplace();
  const VolumeScene scene = sceneOf(window, w);
  GpuVolume& copy = copyOf(scans, scene, w);
  const ErasedParts& erased = w.session.erased();
  const bool some = erased.voxels() > 0;
  if (some) scans.erased.set(erased.mask(), erased.key());
  RaycastInput input = raycastInput(scene, copy, some ? &scans.erased : nullptr, w.view.camera);
  std::optional<SurfaceBehind> behind;
  if (scene.mesh) input.behind = &behind.emplace(drawBehind(window, scene, w.view.camera, sketch));
  input.rows = sketch.rows;
  // A shadow has as many rays as a picture: those of drafts are as coarse as they are.
  input.shadowSize =
      std::clamp(int(0.7f * float(std::max(sketch.size.x, sketch.size.y))), 128, input.shadowSize);
  // The target is drawn to with the last rows.
  const bool last = sketch.rows.y >= 1;
  if (last) window.picture.fit(sketch.size);
  window.raycaster->draw(input, last ? gl::Target(window.picture) : gl::Target(0, {0, 0}, sketch.size));
}

void drawScene(SpaceWindow& window, GpuScans& scans, const Workspace& w, const Sketch& sketch) {
  if (!showsMesh(window, w)) return drawVolume(window, scans, w, sketch);
  window.picture.fit(sketch.size);
  const bool skin = showsSkin(window, w);
  if (skin) window.skin.draw(w, sketch.samples, window.picture);
  if (!skin || window.skin.light() == LightState::none) drawMesh(window, w, sketch.samples, window.picture);
}

// How many pixels the picture gets, so that it is ready within the budget.
glm::ivec2 pictureSize(const SpaceWindow& window, glm::vec2 size, bool moving) {
  const double affordable = (moving ? window.share.seconds : kRestingBudget) / window.secondsPerPixel;
  const double share =
      std::clamp(std::sqrt(affordable / double(size.x * size.y)), moving ? kMovingLeast : kRestingLeast, 1.0);
  return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * share)), glm::ivec2(16));
}

// Whether a surface that rests can have four samples per pixel, so that its outline is no staircase. Skin waits for its
// finished light.
bool affordsSmoothing(const SpaceWindow& window, const Workspace& w, glm::ivec2 size) {
  if (window.state.light < LightState::refined) return false;
  return showsMesh(window, w) && 4 * window.secondsPerPixel * double(size.x) * double(size.y) < kSmoothBudget;
}

// The rows of a volume that rests and that this frame casts: what it affords of those that are left.
glm::vec2 nextRows(const SpaceWindow& window, glm::ivec2 whole) {
  constexpr double kLeastShare = 0.125;  // or a busy machine would draw the window itself most of the time
  const double cost = window.secondsPerPixel * double(whole.x) * double(whole.y);
  const double end = double(window.castRows) + std::max(kBandSeconds / cost, kLeastShare);
  return {window.castRows, end > 1 - kLeastShare ? 1 : end};
}

void redraw(SpaceWindow& window, GpuScans& scans, const Workspace& w, const Sketch& sketch) {
  if (!window.timer) window.timer.emplace();
  if (!window.picture) window.picture = gl::Framebuffer({.size = sketch.size, .filter = gl::Filter::linear});
  const bool lighting = window.state.lighting();
  window.timer->begin();
  drawScene(window, scans, w, sketch);
  window.timer->end();
  window.pictureSeconds = window.timer->seconds();
  if (window.state.moving) window.draftSeconds = window.pictureSeconds;
  window.state.light = shownLight(window, w);
  if (sketch.samples > 1 || lighting || window.state.lighting()) return;
  const double pixels = double(sketch.size.x) * sketch.size.y * double(sketch.rows.y - sketch.rows.x);
  const double perPixel = window.pictureSeconds / pixels;
  // Small pictures cost more per pixel: follow a rise at once, a fall slowly. What others cost says nothing of this.
  const double before = window.costKnown ? window.secondsPerPixel : perPixel;
  window.secondsPerPixel = std::max(perPixel, 0.7 * before + 0.3 * perPixel);
  window.secondsPerPixel = std::clamp(window.secondsPerPixel, 1e-9, 1e-4);
}

// Whether the volume that is shown will soon be another one, which a finished picture of this one would keep waiting.
bool isProvisional(const SpaceWindow& window, const Workspace& w) {
  return !showsMesh(window, w) && w.session.awaitsClassification() &&
         sceneOf(window, w).volume != w.session.scan().volume;
}

// What the next picture is: a draft while something moves, and of a volume that takes long at first; then all pixels, of a
// volume some rows after the other; then smooth edges.
Sampling nextSampling(const SpaceWindow& window, const Workspace& w, glm::ivec2 whole) {
  const PictureState& state = window.state;
  if (state.moving || isProvisional(window, w)) return Sampling::draft;
  if (state.sampling == Sampling::none && !window.share.refines) return Sampling::draft;
  const bool slow = window.secondsPerPixel * double(whole.x) * double(whole.y) > kBandSeconds;
  if (!showsMesh(window, w) && state.sampling == Sampling::none && slow) return Sampling::draft;
  const bool smoothly = state.sampling == Sampling::full && affordsSmoothing(window, w, whole);
  return smoothly ? Sampling::smooth : Sampling::full;
}

Sketch sketchOf(const SpaceWindow& window, const Workspace& w, Sampling wanted, glm::ivec2 whole) {
  if (wanted == Sampling::full && !showsMesh(window, w)) return {whole, 1, nextRows(window, whole)};
  return {pictureSize(window, glm::vec2(whole), wanted == Sampling::draft),
          wanted == Sampling::smooth ? 2 : 1};
}

// Draws the picture anew where what it shows has changed, or while the skin's light is on its way.
void refresh(SpaceWindow& window, GpuScans& scans, Workspace& workspace, glm::ivec2 whole) {
  PictureState& state = window.state;
  if (window.from.see(drawnFrom(window, workspace))) {
    window.drawn = window.failed = {};
    window.costKnown = false;
  }
  const Key key = pictureKey(window, workspace, whole);
  if (window.failed == key) return;  // not again until something changes
  if (window.drawn != key) {
    state.sampling = Sampling::none;
    window.castRows = 0;
  }
  if (state.moving && !window.share.draws && window.picture) return;
  const Sampling wanted = nextSampling(window, workspace, whole);
  if (!state.lighting() && state.sampling >= wanted) return;
  if (wanted > Sampling::draft && !window.share.refines) return;
  if (wanted != Sampling::full) window.castRows = 0;
  const Sketch sketch = sketchOf(window, workspace, wanted, whole);
  const std::string failure = failureOf([&] { redraw(window, scans, workspace, sketch); });
  if (!failure.empty()) {
    window.picture = {};
    window.failed = key;
    workspace.toasts.add(failure, true);
    return;
  }
  window.drawn = key;
  window.castRows = sketch.rows.y < 1 ? sketch.rows.y : 0;
  if (window.castRows > 0) return;
  // A draft that has all pixels is the full picture.
  state.sampling = wanted == Sampling::draft && sketch.size == whole ? Sampling::full : wanted;
  // With the first one a surface is copied to the GPU: whether it can be smoothed is told by another.
  const bool first = !std::exchange(window.costKnown, true);
  if (first && showsMesh(window, workspace) && !affordsSmoothing(window, workspace, whole))
    state.sampling = Sampling::draft;
  if (wanted != Sampling::smooth && showsSkin(window, workspace))
    window.skin.note(workspace, double(sketch.size.x) * sketch.size.y / (double(whole.x) * whole.y));
}

}  // namespace

void advancePicture(SpaceWindow& window, GpuScans& scans, Workspace& workspace, glm::ivec2 whole) {
  PictureState& state = window.state;
  state.light = shownLight(window, workspace);
  const bool lighting = state.lighting(), late = workspace.view.catchingUp || !scans.ready;
  state.moving |= lighting;
  if (!late) refresh(window, scans, workspace, whole);
  state.unfinished = lighting || state.lighting();
  if (!window.compared && wantsSkin(workspace) && !late) {
    for (const std::string& failure : window.skin.refine(workspace, !state.moving))
      workspace.toasts.add(failure, true);
    state.light = shownLight(window, workspace);
  }
  const bool rough = state.sampling == Sampling::full ? affordsSmoothing(window, workspace, whole)
                                                      : state.sampling < Sampling::full;
  state.unfinished |= (late || (rough && !isProvisional(window, workspace))) && !state.moving;
  if (!window.compared) workspace.view.skin.status.settled = showsSkin(window, workspace) && state.settled();
}

}  // namespace sonoskin::ui
