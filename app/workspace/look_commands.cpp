#include "app/workspace/command_tables.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

bool isLight(const W& w) { return w.settings.appearance == Appearance::light; }

void toggleLight(W& w) { w.settings.appearance = isLight(w) ? Appearance::dark : Appearance::light; }

// To the next quarter.
void scaleBy(W& w, int quarters) {
  const double now = w.settings.scale > 0 ? w.settings.scale : w.screenScale;
  const double quarter = quarters > 0 ? std::floor(4 * now + 1e-6) : std::ceil(4 * now - 1e-6);
  w.settings.scale = std::clamp((quarter + quarters) / 4, kLeastScale, kMostScale);
}

template <int percent>
void scaleTo(W& w) {
  w.settings.scale = percent / 100.0;
}

template <int percent>
bool isScale(const W& w) {
  return w.settings.scale == percent / 100.0;
}

constexpr const char* kLook = "Appearance";

// clang-format off
const Command kCommands[] = {
  {"view.light", "Light theme", Menu::view, {}, toggleLight, nullptr, isLight, true, kLook},
  {"view.autoScale", "As the screen has it", Menu::view, control(GLFW_KEY_0), [](W& w) { w.settings.scale = 0; },
   nullptr, [](const W& w) { return w.settings.scale == 0; }, true, kLook},
  {"view.larger", "Larger", Menu::view, control(GLFW_KEY_EQUAL), [](W& w) { scaleBy(w, 1); },
   [](const W& w) { return w.settings.scale < kMostScale; }, nullptr, false, kLook},
  {"view.smaller", "Smaller", Menu::view, control(GLFW_KEY_MINUS), [](W& w) { scaleBy(w, -1); },
   [](const W& w) { return w.settings.scale == 0 || w.settings.scale > kLeastScale; }, nullptr, false, kLook},
  {"view.scale100", "100 %", Menu::view, {}, scaleTo<100>, nullptr, isScale<100>, true, kLook},
  {"view.scale125", "125 %", Menu::view, {}, scaleTo<125>, nullptr, isScale<125>, false, kLook},
  {"view.scale150", "150 %", Menu::view, {}, scaleTo<150>, nullptr, isScale<150>, false, kLook},
  {"view.scale175", "175 %", Menu::view, {}, scaleTo<175>, nullptr, isScale<175>, false, kLook},
  {"view.scale200", "200 %", Menu::view, {}, scaleTo<200>, nullptr, isScale<200>, false, kLook},
  {"view.scale250", "250 %", Menu::view, {}, scaleTo<250>, nullptr, isScale<250>, false, kLook},
  {"view.scale300", "300 %", Menu::view, {}, scaleTo<300>, nullptr, isScale<300>, false, kLook},
};
// clang-format on

}  // namespace

std::span<const Command> lookCommands() { return kCommands; }

}  // namespace sonoskin
