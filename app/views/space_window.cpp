#include "app/views/space_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/views/box_lines.h"
#include "app/widgets/layout.h"
#include "app/widgets/theme.h"
#include "core/pipeline/parameter_key.h"

namespace sonoskin::ui {
namespace {

constexpr double kMovingBudget = 0.045, kRestingBudget = 2, kSmoothBudget = 0.6;  // seconds for one picture
constexpr double kMovingLeast = 0.25, kRestingLeast = 0.6;  // share of the pixels along a side
constexpr double kWheelRests = 0.25;                        // seconds without a turn
constexpr double kPreparingSeconds = 0.06;                  // between looks at how far the skin is prepared

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
  if (wantsSkin(w) && window.skin.shows(w)) {
    window.skin.draw(w, samples, target);
    if (!window.skin.lit()) drawMesh(window, w, samples, target);
  } else if (showsMesh(w)) {
    drawMesh(window, w, samples, target);
  } else {
    drawVolume(window, scans, w, samples, target);
  }
}

// How many pixels the picture gets, so that it is ready within the budget.
glm::ivec2 pictureSize(const SpaceWindow& window, glm::vec2 size, bool moving) {
  const double affordable = (moving ? kMovingBudget : kRestingBudget) / window.secondsPerPixel;
  const double share =
      std::clamp(std::sqrt(affordable / double(size.x * size.y)), moving ? kMovingLeast : kRestingLeast, 1.0);
  return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * share)), glm::ivec2(16));
}

// Whether a surface that rests can have four samples per pixel, so that its outline is no staircase. Skin waits for its
// finished light.
bool smoothEdges(const SpaceWindow& window, const Workspace& w, glm::ivec2 size) {
  if (wantsSkin(w) && window.skin.shows(w) && !window.skin.refined()) return false;
  return showsMesh(w) && 4 * window.secondsPerPixel * double(size.x) * double(size.y) < kSmoothBudget;
}

// Lighting: the skin's light is on its way, whose passes say nothing about the time of a picture.
void redraw(SpaceWindow& window, GpuScans& scans, const Workspace& w, glm::ivec2 size, int samples,
            bool lighting) {
  if (!window.timer) window.timer.emplace();
  if (!window.picture) {
    window.picture = gl::Framebuffer({.size = size, .filter = gl::Filter::linear});
  }
  window.picture.fit(size);
  window.timer->begin();
  drawScene(window, scans, w, samples, window.picture);
  window.timer->end();
  if (samples > 1 || lighting || (wantsSkin(w) && window.skin.shows(w) && !window.skin.complete())) return;
  const double perPixel = window.timer->seconds() / (double(size.x) * size.y);
  // Small pictures cost more per pixel: follow a rise at once, a fall slowly.
  window.secondsPerPixel = std::max(perPixel, 0.7 * window.secondsPerPixel + 0.3 * perPixel);
  window.secondsPerPixel = std::clamp(window.secondsPerPixel, 1e-9, 1e-4);
}

std::string meshCaption(const SpaceWindow& window, const Workspace& w) {
  std::string text = grouped(w.session.results().mesh->triangles.size()) + " triangles";
  if (!w.session.meshIsCurrent()) {
    text += ", older than the parameters";
  } else if (!w.session.meshIsFinal()) {
    text += " (live)";
  }
  const std::string preparing = wantsSkin(w) ? window.skin.caption() : "";
  return preparing.empty() ? text : text + "   " + preparing;
}

std::string caption(const SpaceWindow& window, const Workspace& w) {
  const ViewState& v = w.view;
  if (showsParts(w)) return partCaption(w);
  if (showsMesh(w)) return meshCaption(window, w);
  const char* layer = v.volumeLayer == VolumeLayer::raw ? "Raw volume" : "Classified volume";
  const bool coarse = v.volumeLayer == VolumeLayer::classified && w.session.classifiedIsCoarse();
  return fmt::format("{}{}, level {:.2f}", layer, coarse ? " (coarse)" : "",
                     shownLevel(v, w.session.results()));
}

// The directions of i, j, k as the camera sees them.
void drawAxes(const PaneInput& pane, const Workspace& w) {
  const float u = unit(), length = 26 * u;
  const glm::vec2 middle{pane.corner.x + 42 * u, pane.corner.y + pane.size.y - 42 * u};
  const glm::mat3 view(w.view.camera.view());
  const glm::mat3 direction(w.session.scan().volume->geometry.direction);
  const ImVec4 colours[] = {kSagittal, kCoronal, kAxial};  // of the slices across i, j, k
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int axis = 0; axis < 3; ++axis) {
    const glm::vec3 seen = view * direction[axis];
    const glm::vec2 end = middle + length * glm::vec2(seen.x, -seen.y);
    list.AddLine({middle.x, middle.y}, {end.x, end.y}, ImGui::GetColorU32(colours[axis]), 1.5f * u);
    const glm::vec2 letter = middle + (length + 7 * u) * glm::vec2(seen.x, -seen.y);
    shadedText({letter.x - 3 * u, letter.y - 7 * u}, colours[axis], std::string(1, "ijk"[axis]));
  }
}

}  // namespace

// Draws the picture anew where what it shows has changed, or while the skin's light is on its way. Returns whether its edges
// wait for smoothing.
static bool refresh(SpaceWindow& window, GpuScans& scans, Workspace& workspace, glm::ivec2 whole, bool moving,
                    bool lighting) {
  if (window.from.see(drawnFrom(workspace))) window.drawn = window.failed = {};
  const Key full = pictureKey(window, workspace, whole);
  if (window.failed == full) return false;  // not again until something changes
  const auto key = [&](int kind) { return Hasher("picture").add(full).add(kind).key(); };
  const Key draft = key(0), inFull = key(1), smooth = key(2);
  const glm::ivec2 size = pictureSize(window, glm::vec2(whole), moving);
  // A draft that has all pixels is the full picture; edges are smoothed when that is there.
  const bool smoothly =
      !moving && !lighting && window.drawn == inFull && smoothEdges(window, workspace, whole);
  const Key wanted = smoothly ? smooth : moving ? draft : inFull;
  const bool better = window.drawn == smooth || (!smoothly && window.drawn == inFull);
  if (!lighting && (better || window.drawn == wanted)) return false;
  const std::string failure =
      failureOf([&] { redraw(window, scans, workspace, size, smoothly ? 2 : 1, lighting); });
  if (!failure.empty()) {
    window.picture = {};
    window.failed = full;
    workspace.toasts.add(failure, true);
    return false;
  }
  window.drawn = moving && size == whole ? inFull : wanted;
  if (smoothly) return false;
  if (wantsSkin(workspace) && window.skin.shows(workspace))
    window.skin.note(workspace, double(size.x) * size.y / (double(whole.x) * whole.y));
  return window.drawn == inFull && smoothEdges(window, workspace, whole);
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

double drawSpaceWindow(SpaceWindow& window, GpuScans& scans, Workspace& workspace, const PaneInput& pane) {
  const double now = ImGui::GetTime();
  if (!workspace.session.hasScan()) {
    const Activity activity = workspace.session.activity();
    if (activity.busy) paneText(pane, fmt::format("{}  {:.0f} %", activity.what, 100 * activity.fraction));
    paneTitle(pane, "3D", kSurface, "");
    return -1;
  }
  const bool skin = wantsSkin(workspace);
  if (skin) {
    for (const std::string& failure : window.skin.update(workspace)) workspace.toasts.add(failure, true);
  }
  const PaneInput rest = skin                    ? useSkinTools(window.skinTools, workspace, pane)
                         : showsParts(workspace) ? usePartTools(window.partTools, workspace, pane)
                                                 : pane;
  if (steer(workspace.view.camera, rest)) workspace.view.cameraMoved = true;
  if (pane.wheel != 0) window.restsAt = now + kWheelRests;
  const bool lighting = skin && window.skin.shows(workspace) && !window.skin.complete();
  const bool moving = pane.button >= 0 || workspace.view.toolHeld || now < window.restsAt || lighting;
  const bool late = workspace.view.catchingUp;
  const bool rough = late || refresh(window, scans, workspace, glm::ivec2(pane.size), moving, lighting);

  const bool shown = skin && window.skin.shows(workspace), lit = shown && window.skin.complete();
  if (skin && !late) {
    for (const std::string& failure : window.skin.refine(workspace, !moving))
      workspace.toasts.add(failure, true);
  }
  workspace.view.skin.status.settled = lit && !moving && !rough && window.skin.refined();
  showTexture(pane, window.picture);
  if (workspace.view.cropBox) drawBoxLines(pane, workspace);
  if (skin) drawSkinMarks(window.skinTools, workspace, pane);
  if (showsParts(workspace)) drawPartMarks(window.partTools, pane);
  paneTitle(pane, "3D", kSurface, caption(window, workspace));
  drawAxes(pane, workspace);
  scaleBar(pane, 1 / double(workspace.view.camera.millimetresPerPixel(static_cast<int>(pane.size.y))));
  if (window.picture && (lighting || (shown && !lit) || (rough && !moving))) return 0;
  if (skin && (window.skin.preparing() || window.skin.refining())) return kPreparingSeconds;
  return now < window.restsAt ? window.restsAt - now : -1;
}

}  // namespace sonoskin::ui
