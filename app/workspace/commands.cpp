#include "app/workspace/commands.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cassert>
#include <string_view>

#include "app/document/part_edits.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

bool hasScan(const W& w) { return w.session.hasScan(); }
bool hasMesh(const W& w) { return w.session.results().mesh != nullptr; }
bool busy(const W& w) { return w.session.activity().busy; }

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

void resetParameters(W& w) {
  w.confirmLoss("Setting all parameters back", [&w] {
    w.session.edit({});
    w.session.commitEdit();
  });
}

bool hasErased(const W& w) { return w.session.erased().voxels() > 0; }

bool isCut(const W& w) {
  const RegionOptions &now = w.session.parameters().region, none{};
  return now.cutLow != none.cutLow || now.cutHigh != none.cutHigh;
}

void resetCropBox(W& w) {
  Parameters parameters = w.session.parameters();
  parameters.region = {};
  w.session.edit(parameters);
  w.session.commitEdit();
}

void scaleBrush(W& w, double factor) {
  w.view.brushRadius = std::clamp(w.view.brushRadius * factor, kLeastBrush, kMostBrush);
}

bool canShowParts(const W& w) { return hasMesh(w) && hasParts(w.session.results()); }

void toggleParts(W& w) {
  w.view.parts = !w.view.parts;
  if (w.view.parts) w.view.content = SpaceContent::mesh;
}

void leaveFaceAlone(W& w) {
  w.session.editParts(faceAlone(w.session.results(), w.session.parameters().mesh));
}

void proposeParts(W& w) {
  MeshOptions mesh = w.session.parameters().mesh;
  const MeshOptions none{};
  mesh.parts = none.parts;
  mesh.companions = none.companions;
  mesh.partsAdd = mesh.partsDrop = mesh.partsCut = {};
  w.session.editParts(mesh);
}

bool hasClassified(const W& w) { return w.session.results().classified && !w.session.classifiedIsCoarse(); }

bool hasSteps(const W& w) { return w.session.hasScan() && w.session.scan().timeSteps > 1; }

bool showsSkin(const W& w) {
  return w.view.content == SpaceContent::mesh && w.view.meshStyle == MeshStyle::skin && hasMesh(w);
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

// The tool that Escape puts away; null for none. Work that a person waits for ends before the tools that wait for it.
const Tool* chosenTool(const W& w) {
  const bool waits = w.session.activity().blocking;
  const auto found = std::ranges::find_if(
      kTools, [&](Tool tool) { return isChosen(w.view, tool) && (!waits || tool == Tool::landmark); });
  return found == kTools.end() ? nullptr : &*found;
}

bool isAsked(const W& w) { return w.question || w.choice || w.rawQuestion; }

// Escape ends what is most in the way.
void escape(W& w) {
  if (isAsked(w)) {
    w.question.reset();
    w.choice.reset();
    w.rawQuestion.reset();
  } else if (const Tool* tool = chosenTool(w)) {
    putAway(w.view, *tool);
  } else if (busy(w)) {
    w.session.cancel();
  } else {
    w.view.maximised.reset();
  }
}
bool canEscape(const W& w) { return isAsked(w) || chosenTool(w) || busy(w) || w.view.maximised; }

constexpr Shortcut key(int k) { return {k, false, false}; }
constexpr Shortcut control(int k) { return {k, true, false}; }
constexpr Shortcut controlShift(int k) { return {k, true, true}; }

// clang-format off
const Command kCommands[] = {
  {"file.open", "Open volume...", Menu::file, control(GLFW_KEY_O),
   [](W& w) { w.files.ask(ui::FilePurpose::openVolume, w.settings.folder, ""); }},
  {"file.phantom", "Open phantom", Menu::file, control(GLFW_KEY_P), [](W& w) { w.confirmLoss("Opening the phantom", [&w] { w.session.openPhantom(); }); }},
  {"file.openRecipe", "Open recipe...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::openRecipe, w.settings.folder, ""); }, nullptr, nullptr, true},
  {"file.saveRecipe", "Save recipe...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveRecipe, w.settings.folder, "sonoskin.recipe.json"); }},
  {"file.saveMesh", "Save mesh...", Menu::file, control(GLFW_KEY_S),
   [](W& w) { w.files.ask(ui::FilePurpose::saveMesh, w.settings.folder, w.session.proposedName(".ply")); }, hasMesh, nullptr, true},
  {"file.saveSequence", "Save a mesh of each time step...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveSequence, w.settings.folder, w.session.proposedName(".ply")); }, hasSteps},
  {"file.savePrint", "Save for printing...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::savePrint, w.settings.folder, w.session.proposedName(".stl")); }, hasMesh},
  {"file.saveScan", "Save scan for other programs...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveScan, w.settings.folder, "scan.nrrd"); }, hasScan, nullptr, true},
  {"file.saveClassified", "Save classified volume...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveClassified, w.settings.folder, "classified.nrrd"); }, hasClassified},
  {"file.saveSkin", "Save surface with skin...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveSkin, w.settings.folder, w.session.proposedName(".glb")); }, showsSkin},
  {"file.saveLitSkin", "Save surface with skin and light...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveLitSkin, w.settings.folder, w.session.proposedName(".glb")); }, showsSkin},
  {"file.savePicture", "Save picture...", Menu::file, key(GLFW_KEY_F12),
   [](W& w) { w.files.ask(ui::FilePurpose::savePicture, w.settings.folder, w.session.proposedName(".png")); }, hasScan},
  {"file.openErased", "Open erased parts...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::openErased, w.settings.folder, ""); }, hasScan, nullptr, true},
  {"file.saveErased", "Save erased parts...", Menu::file, {},
   [](W& w) { w.files.ask(ui::FilePurpose::saveErased, w.settings.folder, w.session.proposedName(".erased.nrrd")); }, hasErased},
  {"file.quit", "Quit", Menu::file, control(GLFW_KEY_Q), [](W& w) { w.confirmLoss("Quitting", [&w] { w.quit = true; }); }, nullptr, nullptr, true},

  {"edit.undo", "Undo", Menu::edit, control(GLFW_KEY_Z), [](W& w) { w.session.undo(); },
   [](const W& w) { return w.session.canUndo(); }},
  {"edit.redo", "Redo", Menu::edit, controlShift(GLFW_KEY_Z), [](W& w) { w.session.redo(); },
   [](const W& w) { return w.session.canRedo(); }},
  {"edit.reset", "All parameters to their defaults", Menu::edit, {}, resetParameters, nullptr, nullptr, true},

  {"view.resetCamera", "Look at the face", Menu::view, key(GLFW_KEY_R), [](W& w) { w.lookAtFace(); }, hasScan},
  {"view.resetAll", "Reset all views", Menu::view, controlShift(GLFW_KEY_R), showAll, hasScan},
  {"view.play", "Play the recording", Menu::view, key(GLFW_KEY_SPACE), [](W& w) { play(w, !w.play.on); }, hasSteps,
   [](const W& w) { return w.play.on; }, true},
  {"view.nextStep", "Next time step", Menu::view, key(GLFW_KEY_PERIOD), [](W& w) { stepBy(w, 1); }, hasSteps},
  {"view.previousStep", "Time step before", Menu::view, key(GLFW_KEY_COMMA), [](W& w) { stepBy(w, -1); }, hasSteps},
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
  {"view.lamp", "Lamp in the skin view", Menu::view, key(GLFW_KEY_K),
   [](W& w) { w.view.skin.lamp = !w.view.skin.lamp; }, showsSkin, [](const W& w) { return w.view.skin.lamp; }},
  {"view.maximise", "3D view alone", Menu::view, key(GLFW_KEY_F), [](W& w) { toggleMaximised(w, Pane::space); },
   nullptr, [](const W& w) { return w.view.maximised == Pane::space; }, true},
  {"view.messages", "Messages", Menu::view, key(GLFW_KEY_N), toggleMessages, nullptr,
   [](const W& w) { return w.toasts.log.shown; }},

  {"region.box", "Show the crop box", Menu::region, key(GLFW_KEY_B), [](W& w) { w.view.cropBox = !w.view.cropBox; },
   hasScan, [](const W& w) { return w.view.cropBox; }},
  {"region.resetBox", "Crop box around the whole volume", Menu::region, {}, resetCropBox, isCut},
  {"region.erase", "Erase in the slices", Menu::region, key(GLFW_KEY_E), [](W& w) { toggle(w.view.sliceTool, Tool::eraser); },
   hasScan, [](const W& w) { return isChosen(w.view, Tool::eraser); }, true},
  {"region.smaller", "Smaller eraser", Menu::region, key(GLFW_KEY_LEFT_BRACKET), [](W& w) { scaleBrush(w, 1 / 1.2); }, hasScan},
  {"region.larger", "Larger eraser", Menu::region, key(GLFW_KEY_RIGHT_BRACKET), [](W& w) { scaleBrush(w, 1.2); }, hasScan},
  {"region.clear", "Bring everything back", Menu::region, {}, [](W& w) { w.session.clearErased(); }, hasErased},

  {"surface.reconstruct", "Reconstruct surface", Menu::surface, control(GLFW_KEY_ENTER),
   [](W& w) { w.session.reconstruct(); }, hasScan},
  {"surface.follow", "Surface follows the parameters", Menu::surface, key(GLFW_KEY_L),
   [](W& w) { w.session.followParameters(!w.session.followsParameters()); }, nullptr,
   [](const W& w) { return w.session.followsParameters(); }},
  {"surface.cancel", "Cancel", Menu::surface, key(GLFW_KEY_ESCAPE), escape, canEscape},
  {"surface.parts", "Parts in colours", Menu::surface, key(GLFW_KEY_P), toggleParts, canShowParts,
   [](const W& w) { return w.view.parts; }, true},
  {"surface.faceAlone", "The face alone", Menu::surface, {}, leaveFaceAlone, canShowParts},
  {"surface.proposeParts", "Parts as proposed", Menu::surface, {}, proposeParts, canShowParts},

  {"help.keys", "Mouse and keys", Menu::help, key(GLFW_KEY_H), [](W& w) { w.keysShown = !w.keysShown; }},
  {"help.about", "About Sonoskin", Menu::help, {}, [](W& w) { w.aboutShown = true; }},
};
// clang-format on

}  // namespace

std::span<const Command> commands() { return kCommands; }

const Command& command(std::string_view id) {
  const Command* found = kCommands;
  while (found->id != id) {
    ++found;
    assert(found != std::end(kCommands));
  }
  return *found;
}

bool isEnabled(const Command& c, const Workspace& workspace) { return !c.enabled || c.enabled(workspace); }

bool runShortcut(const Shortcut& shortcut, Workspace& workspace) {
  for (const Command& c : kCommands) {
    if (!(c.shortcut == shortcut) || !isEnabled(c, workspace)) continue;
    c.run(workspace);
    return true;
  }
  return false;
}

std::string shortcutText(const Shortcut& shortcut) {
  if (shortcut.key == 0) return {};
  std::string text = shortcut.control ? "Ctrl+" : "";
  if (shortcut.shift) text += "Shift+";
  switch (shortcut.key) {
    case GLFW_KEY_ENTER:
      return text + "Enter";
    case GLFW_KEY_ESCAPE:
      return text + "Esc";
    case GLFW_KEY_F12:
      return text + "F12";
    default:
      return text + static_cast<char>(shortcut.key);  // letters and digits are their own codes
  }
}

}  // namespace sonoskin
