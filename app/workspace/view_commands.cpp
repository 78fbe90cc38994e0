#include "app/workspace/command_tables.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

void toggleMaximised(W& w, Pane pane) {
  if (w.view.maximised == pane) {
    w.view.maximised.reset();
  } else {
    w.view.maximised = pane;
  }
}

void showAll(W& w) {
  resetView(w.view, w.session.scan(), w.session.beam());
  w.lookAtFace();
}

void showMesh(W& w, MeshStyle style) {
  w.view.content = SpaceContent::mesh;
  w.view.parts = false;
  w.view.meshStyle = style;
}

void toggleMessages(W& w) {
  if (w.toasts.log.shown)
    w.toasts.log.shown = false;
  else
    w.toasts.log.open();
}

void editColours(W& w) {
  w.view.volume.edited = !w.view.volume.edited;
  if (!w.view.volume.edited) return;
  w.view.content = SpaceContent::volume;
  w.view.volumeStyle = VolumeStyle::translucent;
}

constexpr const char* kRecording = "Recording";

// clang-format off
const Command kCommands[] = {
  {"view.resetCamera", "Look at the face", Menu::view, key(GLFW_KEY_R), [](W& w) { w.lookAtFace(); }, hasScan},
  {"view.resetAll", "Reset all views", Menu::view, controlShift(GLFW_KEY_R), showAll, hasScan},
  {"view.play", "Play the recording", Menu::view, key(GLFW_KEY_SPACE), [](W& w) { play(w, !w.play.on); }, hasSteps,
   [](const W& w) { return w.play.on; }, true, kRecording},
  {"view.nextStep", "Next time step", Menu::view, key(GLFW_KEY_PERIOD), [](W& w) { stepBy(w, 1); }, hasSteps,
   nullptr, false, kRecording},
  {"view.previousStep", "Time step before", Menu::view, key(GLFW_KEY_COMMA), [](W& w) { stepBy(w, -1); }, hasSteps,
   nullptr, false, kRecording},
  {"view.raw", "Slices: raw", Menu::view, key(GLFW_KEY_1), [](W& w) { w.view.layer = SliceLayer::raw; }, hasScan,
   [](const W& w) { return w.view.layer == SliceLayer::raw; }, true},
  {"view.classified", "Slices: classified", Menu::view, key(GLFW_KEY_2),
   [](W& w) { w.view.layer = SliceLayer::classified; }, hasScan,
   [](const W& w) { return w.view.layer == SliceLayer::classified; }},
  {"view.thinned", "Slices: thinned", Menu::view, key(GLFW_KEY_3), [](W& w) { w.view.layer = SliceLayer::thinned; },
   hasScan, [](const W& w) { return w.view.layer == SliceLayer::thinned; }},
  {"view.voxels", "Slices: mark the surface voxels", Menu::view, key(GLFW_KEY_4),
   [](W& w) { w.view.surfaceVoxels = !w.view.surfaceVoxels; }, hasScan,
   [](const W& w) { return w.view.surfaceVoxels; }},
  {"view.volume", "3D: volume", Menu::view, key(GLFW_KEY_V), [](W& w) { w.view.content = SpaceContent::volume; },
   hasScan, [](const W& w) { return w.view.content == SpaceContent::volume; }, true},
  {"view.mesh", "3D: surface mesh", Menu::view, key(GLFW_KEY_M), [](W& w) { showMesh(w, MeshStyle::clay); },
   hasMesh, [](const W& w) { return w.view.content == SpaceContent::mesh && !showsSkin(w); }},
  {"view.skin", "3D: skin", Menu::view, key(GLFW_KEY_S), [](W& w) { showMesh(w, MeshStyle::skin); }, hasMesh, showsSkin},
  {"view.unmeasured", "Mark what was not measured", Menu::view, {}, [](W& w) { w.view.unmeasured = !w.view.unmeasured; },
   hasMesh, [](const W& w) { return w.view.unmeasured; }},
  {"view.colours", "Colours of the volume", Menu::view, {}, editColours, hasScan, [](const W& w) { return w.view.volume.edited; }},
  {"view.turntable", "Turntable", Menu::view, key(GLFW_KEY_T), [](W& w) { w.view.turntable = !w.view.turntable; },
   hasScan, [](const W& w) { return w.view.turntable; }},
  {"view.lamp", "Lamp in the skin view", Menu::view, key(GLFW_KEY_K),
   [](W& w) { w.view.skin.lamp = !w.view.skin.lamp; }, showsSkin, [](const W& w) { return w.view.skin.lamp; }},
  {"view.maximise", "3D view alone", Menu::view, key(GLFW_KEY_F), [](W& w) { toggleMaximised(w, Pane::space); },
   nullptr, [](const W& w) { return w.view.maximised == Pane::space; }, true},
  {"view.messages", "Messages", Menu::view, key(GLFW_KEY_N), toggleMessages, nullptr,
   [](const W& w) { return w.toasts.log.shown; }},
};
// clang-format on

}  // namespace

std::span<const Command> viewCommands() { return kCommands; }

}  // namespace sonoskin
