#include <cmath>

#include "app/views/oblique_marks.h"

namespace sonoskin::ui {
namespace {

// Where the mouse is around the cross-hair in a slice's picture: radians from the right toward below.
double angleOf(const Workspace& w, const ToolPane& pane) {
  const glm::dvec2 from = glm::dvec2(pane.input.mouse) - pane.slice->frame.toPixel(w.view.cursor);
  return std::atan2(from.y, from.x);
}

}  // namespace

PaneInput useObliqueTool(ToolState& state, Workspace& w, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  if (!pane.slice->plane) return input;
  const double angle = angleOf(w, pane);
  if (state.held) {
    const SliceFrame& frame = pane.slice->frame;
    const glm::dvec3 axis = glm::normalize(glm::cross(frame.right, frame.down));
    PlaneDirections& plane = w.view.oblique.directions;
    plane = turnedAbout(plane, axis, angle - state.obliqueAt);
    state.obliqueAt = angle;
  } else if (holdsLeft(input) && input.pressed && !input.shift && endUnderMouse(w, pane)) {
    state.obliqueAt = angle;
    state.held = Tool::oblique;
  }
  return state.held ? withoutButton(input) : input;
}

}  // namespace sonoskin::ui
