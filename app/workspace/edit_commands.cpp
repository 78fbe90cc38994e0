#include "app/workspace/command_tables.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

void resetParameters(W& w) {
  w.confirmLoss(tr("Setting all parameters back"), [&w] {
    w.session.edit({});
    w.session.commitEdit();
  });
}

// clang-format off
const Command kCommands[] = {
  {"edit.undo", "Undo", Menu::edit, control(GLFW_KEY_Z), [](W& w) { w.session.undo(); },
   [](const W& w) { return w.session.canUndo(); }},
  {"edit.redo", "Redo", Menu::edit, controlShift(GLFW_KEY_Z), [](W& w) { w.session.redo(); },
   [](const W& w) { return w.session.canRedo(); }},
  {"edit.history", "History", Menu::edit, {}, [](W& w) { w.historyShown = !w.historyShown; }, hasScan,
   [](const W& w) { return w.historyShown; }},
  {"edit.reset", "All parameters to their defaults", Menu::edit, {}, resetParameters, nullptr, nullptr, true},
};
// clang-format on

}  // namespace

std::span<const Command> editCommands() { return kCommands; }

}  // namespace sonoskin
