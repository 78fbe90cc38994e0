#include "app/workspace/commands.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <vector>

#include "app/texts/texts.h"
#include "app/workspace/command_tables.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

std::vector<Command> allCommands() {
  std::vector<Command> all;
  for (const auto table : {fileCommands, editCommands, viewCommands, layoutCommands, planeCommands,
                           sliceCommands, measureCommands, clipCommands, obliqueCommands, lookCommands,
                           languageCommands, stepCommands, regionCommands, surfaceCommands, helpCommands})
    all.insert(all.end(), table().begin(), table().end());
  return all;
}

// KeyName: a key that is no letter, as people call it.
struct KeyName {
  int key;
  const char* name;
};
constexpr std::array<KeyName, 10> kKeyNames{{{GLFW_KEY_ENTER, "Enter"},
                                             {GLFW_KEY_SPACE, "Space"},
                                             {GLFW_KEY_ESCAPE, "Esc"},
                                             {GLFW_KEY_DELETE, "Del"},
                                             {GLFW_KEY_LEFT, "←"},
                                             {GLFW_KEY_RIGHT, "→"},
                                             {GLFW_KEY_UP, "↑"},
                                             {GLFW_KEY_DOWN, "↓"},
                                             {GLFW_KEY_PAGE_UP, "PgUp"},
                                             {GLFW_KEY_PAGE_DOWN, "PgDn"}}};

}  // namespace

bool hasScan(const Workspace& w) { return w.session.hasScan(); }

bool hasMesh(const Workspace& w) { return w.session.results().mesh != nullptr; }

bool hasErased(const Workspace& w) { return w.session.erased().voxels() > 0; }

bool hasSteps(const Workspace& w) { return w.session.hasScan() && w.session.scan().timeSteps > 1; }

bool showsSkin(const Workspace& w) {
  return w.view.content == SpaceContent::mesh && w.view.meshStyle == MeshStyle::skin && hasMesh(w);
}

std::span<const Command> commands() {
  static const std::vector<Command> all = allCommands();
  return all;
}

const Command& command(std::string_view id) {
  const auto found = std::ranges::find_if(commands(), [id](const Command& c) { return c.id == id; });
  assert(found != commands().end());
  return *found;
}

bool isEnabled(const Command& c, const Workspace& workspace) { return !c.enabled || c.enabled(workspace); }

bool runShortcut(const Shortcut& shortcut, Workspace& workspace) {
  for (const Command& c : commands()) {
    if (!(c.shortcut == shortcut) || !isEnabled(c, workspace)) continue;
    c.run(workspace);
    return true;
  }
  return false;
}

std::string shortcutText(const Shortcut& shortcut) {
  if (shortcut.key == 0) return {};
  std::string text = shortcut.control ? tr("Ctrl+") : "";
  if (shortcut.shift) text += tr("Shift+");
  if (const auto named = std::ranges::find(kKeyNames, shortcut.key, &KeyName::key); named != kKeyNames.end())
    return text + tr(named->name);
  if (shortcut.key >= GLFW_KEY_F1 && shortcut.key <= GLFW_KEY_F25)
    return text + "F" + std::to_string(shortcut.key - GLFW_KEY_F1 + 1);
  return text + static_cast<char>(shortcut.key);  // letters and digits are their own codes
}

}  // namespace sonoskin
