#include "app/workspace/help_state.h"

#include <utility>

#include "app/workspace/workspace.h"

namespace sonoskin {

bool canOpenPalette(const Workspace& w) { return !w.isAsked(); }

void openPalette(Workspace& w) {
  w.help.paletteShown = w.help.paletteOpens = true;
  w.help.words.clear();
  w.help.chosen = 0;
}

bool hasHelpWindow(const Workspace& w) {
  const HelpState& help = w.help;
  return help.paletteShown || w.keysShown || w.aboutShown || w.historyShown || w.sheetShown ||
         w.exportShown || help.tour || help.offered || w.toasts.log.shown;
}

void closeHelpWindow(Workspace& w) {
  HelpState& help = w.help;
  for (bool* shown :
       {&help.paletteShown, &w.keysShown, &w.aboutShown, &w.historyShown, &w.sheetShown, &w.exportShown})
    if (std::exchange(*shown, false)) return;
  if (help.tour || help.offered) {
    help.tour.reset();
    help.offered = false;
  } else {
    w.toasts.log.shown = false;
  }
}

}  // namespace sonoskin
