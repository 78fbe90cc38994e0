#include "app/workspace/command_tables.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "app/document/part_edits.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

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

// The tool that Escape puts away; null for none. Work that a person waits for ends before the tools that wait for it.
const Tool* chosenTool(const W& w) {
  const bool waits = w.session.activity().blocking;
  const auto found = std::ranges::find_if(
      kTools, [&](Tool tool) { return isChosen(w.view, tool) && (!waits || tool == Tool::landmark); });
  return found == kTools.end() ? nullptr : &*found;
}

bool busy(const W& w) { return w.session.activity().busy; }

// Escape ends what is most in the way.
void escape(W& w) {
  if (w.isAsked()) {
    w.dropQuestions();
  } else if (hasHelpWindow(w)) {
    closeHelpWindow(w);
  } else if (const Tool* tool = chosenTool(w)) {
    putAway(w.view, *tool);
  } else if (busy(w)) {
    play(w, false);
    w.session.cancel();
  } else {
    w.view.maximised.reset();
  }
}
bool canEscape(const W& w) {
  return w.isAsked() || hasHelpWindow(w) || chosenTool(w) || busy(w) || w.view.maximised;
}

// clang-format off
const Command kCommands[] = {
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
};
// clang-format on

}  // namespace

std::span<const Command> surfaceCommands() { return kCommands; }

}  // namespace sonoskin
