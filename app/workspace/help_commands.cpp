#include "app/workspace/command_tables.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/tour.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

// clang-format off
const Command kCommands[] = {
  {"help.palette", "All commands...", Menu::help, control(GLFW_KEY_K), openPalette, canOpenPalette},
  {"help.keys", "Mouse and keys", Menu::help, key(GLFW_KEY_H), [](W& w) { w.keysShown = !w.keysShown; }},
  {"help.tour", "Tour in five steps", Menu::help, {}, startTour, nullptr, onTour, true},
  {"help.tourNext", "Next step of the tour", Menu::help, key(GLFW_KEY_ENTER), nextCard, onTour},
  {"help.tourBack", "Step of the tour before", Menu::help, {GLFW_KEY_ENTER, false, true}, previousCard, canGoBack},
  {"help.about", "About Sonoskin", Menu::help, {}, [](W& w) { w.aboutShown = true; }, nullptr, nullptr, true},
};
// clang-format on

}  // namespace

std::span<const Command> helpCommands() { return kCommands; }

}  // namespace sonoskin
