#include "app/workspace/command_tables.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

bool isCut(const W& w) {
  const RegionOptions &now = w.session.parameters().region, none{};
  return now.cutLow != none.cutLow || now.cutHigh != none.cutHigh;
}

void resetCropBox(W& w) {
  Parameters parameters = w.session.parameters();
  parameters.region = {};
  w.session.edit(parameters);
  w.session.commitEdit();
}

void scaleBrush(W& w, double factor) {
  w.view.brushRadius = std::clamp(w.view.brushRadius * factor, kLeastBrush, kMostBrush);
}

// In slices and in 3D alike.
void toggleLasso(W& w) {
  const bool on = isChosen(w.view, Tool::lasso);
  w.view.sliceTool = w.view.spaceTool = on ? Tool::crossHair : Tool::lasso;
}

// clang-format off
const Command kCommands[] = {
  {"region.box", "Show the crop box", Menu::region, key(GLFW_KEY_B), [](W& w) { w.view.cropBox = !w.view.cropBox; },
   hasScan, [](const W& w) { return w.view.cropBox; }},
  {"region.resetBox", "Crop box around the whole volume", Menu::region, {}, resetCropBox, isCut},
  {"region.erase", "Erase in the slices", Menu::region, key(GLFW_KEY_E), [](W& w) { toggle(w.view.sliceTool, Tool::eraser); },
   hasScan, [](const W& w) { return isChosen(w.view, Tool::eraser); }, true},
  {"region.lasso", "Cut out by an outline", Menu::region, key(GLFW_KEY_X), toggleLasso, hasScan,
   [](const W& w) { return isChosen(w.view, Tool::lasso); }},
  {"region.smaller", "Smaller eraser", Menu::region, key(GLFW_KEY_LEFT_BRACKET), [](W& w) { scaleBrush(w, 1 / 1.2); }, hasScan},
  {"region.larger", "Larger eraser", Menu::region, key(GLFW_KEY_RIGHT_BRACKET), [](W& w) { scaleBrush(w, 1.2); }, hasScan},
  {"region.clear", "Bring everything back", Menu::region, {}, [](W& w) { w.session.clearErased(); }, hasErased},
};
// clang-format on

}  // namespace

std::span<const Command> regionCommands() { return kCommands; }

}  // namespace sonoskin
