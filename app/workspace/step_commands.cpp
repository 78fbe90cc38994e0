#include "app/workspace/command_tables.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

template <Step step>
void open(W& w) {
  w.step = step;
}

template <Step step>
bool isOpen(const W& w) {
  return w.step == step;
}

// clang-format off
const Command kCommands[] = {
  {"step.volume", "Volume", Menu::steps, control(GLFW_KEY_1), open<Step::volume>, nullptr, isOpen<Step::volume>},
  {"step.region", "Region", Menu::steps, control(GLFW_KEY_2), open<Step::region>, nullptr, isOpen<Step::region>},
  {"step.classify", "Classify", Menu::steps, control(GLFW_KEY_3), open<Step::classify>, nullptr, isOpen<Step::classify>},
  {"step.surface", "Surface", Menu::steps, control(GLFW_KEY_4), open<Step::surface>, nullptr, isOpen<Step::surface>},
  {"step.skin", "Skin", Menu::steps, control(GLFW_KEY_5), open<Step::skin>, nullptr, isOpen<Step::skin>},
  {"step.export", "Export", Menu::steps, control(GLFW_KEY_6), open<Step::output>, nullptr, isOpen<Step::output>},
};
// clang-format on

}  // namespace

std::span<const Command> stepCommands() { return kCommands; }

}  // namespace sonoskin
