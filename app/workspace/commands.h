#pragma once

#include <array>
#include <span>
#include <string>

namespace sonoskin {

struct Workspace;

enum class Menu { file, edit, view, steps, region, surface, help };

// kMenuTitles: of the menus, by Menu, in English.
inline constexpr std::array<const char*, 7> kMenuTitles{"File",   "Edit",    "View", "Go",
                                                        "Region", "Surface", "Help"};

// Shortcut: a key of GLFW, with Control and Shift as said; 0 for none.
struct Shortcut {
  int key = 0;
  bool control = false, shift = false;
  friend bool operator==(const Shortcut&, const Shortcut&) = default;
};

// Command: one thing the person can do. Menu, keys, the list of keys and the tests read the same table.
struct Command {
  const char* id;     // "file.open"
  const char* title;  // as the menu shows it
  Menu menu;
  Shortcut shortcut;
  void (*run)(Workspace&);
  bool (*enabled)(const Workspace&) = nullptr;  // none: always
  bool (*checked)(const Workspace&) = nullptr;  // for switches
  bool separator = false;                       // a line above it in the menu
  const char* submenu = nullptr;                // of the menu, in which it stands with its neighbours
};

// commands: all of them, in the order of the menus.
std::span<const Command> commands();
const Command& command(std::string_view id);  // must exist
bool isEnabled(const Command& command, const Workspace& workspace);

// runShortcut: runs the command that has the shortcut, where it is enabled; whether there was one.
bool runShortcut(const Shortcut& shortcut, Workspace& workspace);

// shortcutText: "Ctrl+Shift+Z"; empty without a key.
std::string shortcutText(const Shortcut& shortcut);

}  // namespace sonoskin
