// The slice that can be turned.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/workspace/command_tables.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

constexpr double kStep = 5;  // degrees

bool isShown(const W& w) { return hasScan(w) && w.settings.layout.layout == Layout::oblique; }

enum class Axis { right, down, normal };

// By a step about one of the picture's own axes.
template <Axis axis, int sign>
void turn(W& w) {
  PlaneDirections& plane = w.view.oblique.directions;
  const glm::dvec3 about = axis == Axis::right  ? plane.right
                           : axis == Axis::down ? plane.down
                                                : plane.normal();
  plane = turnedAbout(plane, about, sign * glm::radians(kStep));
}

void reset(W& w) { resetOblique(w.view, w.session.scan().volume->geometry); }

constexpr const char* kMenu = "Oblique slice";

// clang-format off
const Command kCommands[] = {
  {"oblique.up", "Tilt by 5° upward", Menu::view, {GLFW_KEY_UP, false, true}, turn<Axis::right, 1>, isShown, nullptr, true, kMenu},
  {"oblique.down", "Tilt by 5° downward", Menu::view, {GLFW_KEY_DOWN, false, true}, turn<Axis::right, -1>, isShown, nullptr, false, kMenu},
  {"oblique.left", "Turn by 5° to the left", Menu::view, {GLFW_KEY_LEFT, false, true}, turn<Axis::down, 1>, isShown, nullptr, false, kMenu},
  {"oblique.right", "Turn by 5° to the right", Menu::view, {GLFW_KEY_RIGHT, false, true}, turn<Axis::down, -1>, isShown, nullptr, false, kMenu},
  {"oblique.clockwise", "Roll by 5° clockwise", Menu::view, controlShift(GLFW_KEY_RIGHT), turn<Axis::normal, -1>, isShown, nullptr, false, kMenu},
  {"oblique.counter", "Roll by 5° counter-clockwise", Menu::view, controlShift(GLFW_KEY_LEFT), turn<Axis::normal, 1>, isShown, nullptr, false, kMenu},
  {"oblique.reset", "As the axial plane", Menu::view, {}, reset, hasScan, nullptr, true, kMenu},
};
// clang-format on

}  // namespace

std::span<const Command> obliqueCommands() { return kCommands; }

}  // namespace sonoskin
