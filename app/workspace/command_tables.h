#pragma once

#include "app/workspace/commands.h"

namespace sonoskin {

// The tables of commands, one a menu and file, and what they share.

std::span<const Command> fileCommands();
std::span<const Command> editCommands();
std::span<const Command> viewCommands();
std::span<const Command> lookCommands();      // theme and scale, in the menu of the views
std::span<const Command> languageCommands();  // in the same menu
std::span<const Command> stepCommands();
std::span<const Command> layoutCommands();  // in the menu of the views, as the next five
std::span<const Command> planeCommands();
std::span<const Command> sliceCommands();
std::span<const Command> measureCommands();
std::span<const Command> clipCommands();
std::span<const Command> obliqueCommands();
std::span<const Command> regionCommands();
std::span<const Command> surfaceCommands();
std::span<const Command> helpCommands();

constexpr Shortcut key(int k) { return {k, false, false}; }
constexpr Shortcut control(int k) { return {k, true, false}; }
constexpr Shortcut controlShift(int k) { return {k, true, true}; }

// When a command can be given.
bool hasScan(const Workspace& workspace);
bool hasMesh(const Workspace& workspace);
bool hasErased(const Workspace& workspace);
bool hasSteps(const Workspace& workspace);  // of time
bool showsSkin(const Workspace& workspace);

}  // namespace sonoskin
