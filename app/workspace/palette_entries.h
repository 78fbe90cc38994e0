#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/workspace/commands.h"

namespace sonoskin {

// PaletteEntry: a command, or a parameter whose row is opened.
//   id     "file.open", "classification.beta"
//   where  its menu or step; or why it cannot be given just now
//   key    of a command, for people
struct PaletteEntry {
  std::string id, title, where, key;
  bool enabled = true;
  std::function<void(Workspace&)> run;
};

// paletteEntries: those whose titles and places fit the words (misfit), the best first, and of those that fit alike what can be
// done before what cannot. Without words all commands, in the order of the menus.
std::vector<PaletteEntry> paletteEntries(std::string_view words, const Workspace& workspace);

// commandTitle: in the window's language; where it stands in a menu of a menu, with the title of that, which says what it is about.
std::string commandTitle(const Command& command);

// whatLacks: why a command cannot be given just now, in a few words; empty where it can, or nobody has said.
const char* whatLacks(const Command& command, const Workspace& workspace);

}  // namespace sonoskin
