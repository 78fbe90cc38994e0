#include "app/workspace/command_tables.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

// clang-format off
const Command kCommands[] = {
  {"help.keys", "Mouse and keys", Menu::help, key(GLFW_KEY_H), [](W& w) { w.keysShown = !w.keysShown; }},
  {"help.about", "About Sonoskin", Menu::help, {}, [](W& w) { w.aboutShown = true; }},
};
// clang-format on

}  // namespace

std::span<const Command> helpCommands() { return kCommands; }

}  // namespace sonoskin
