// What is measured between marks.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/command_tables.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

template <MeasureKind kind>
bool measures(const W& w) {
  return w.view.sliceTool == Tool::measure && w.view.measuring == kind;
}

template <MeasureKind kind>
void measure(W& w) {
  const bool on = measures<kind>(w);
  putAway(w.view, Tool::measure);
  if (on) return;
  w.view.sliceTool = Tool::measure;
  w.view.measuring = kind;
}

bool hasMeasures(const W& w) { return !w.view.measures.empty(); }

constexpr const char* kMeasure = "Measure";

// clang-format off
const Command kCommands[] = {
  {"measure.distance", "Distance: two marks", Menu::view, key(GLFW_KEY_D), measure<MeasureKind::distance>, hasScan,
   measures<MeasureKind::distance>, true, kMeasure},
  {"measure.angle", "Angle: three marks", Menu::view, {GLFW_KEY_D, false, true}, measure<MeasureKind::angle>, hasScan,
   measures<MeasureKind::angle>, false, kMeasure},
  {"measure.area", "Area: marks around it", Menu::view, controlShift(GLFW_KEY_D), measure<MeasureKind::area>, hasScan,
   measures<MeasureKind::area>, false, kMeasure},
  {"measure.deleteLast", "Delete the last", Menu::view, key(GLFW_KEY_DELETE), [](W& w) { w.view.measures.pop_back(); },
   hasMeasures, nullptr, true, kMeasure},
  {"measure.deleteAll", "Delete all", Menu::view, {}, [](W& w) { w.view.measures.clear(); }, hasMeasures, nullptr, false,
   kMeasure},
};
// clang-format on

}  // namespace

std::span<const Command> measureCommands() { return kCommands; }

}  // namespace sonoskin
