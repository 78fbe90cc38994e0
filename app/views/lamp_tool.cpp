#include <algorithm>
#include <cmath>

#include "app/views/lamp_marks.h"
#include "app/views/skin_scene.h"
#include "app/views/tools.h"
#include "app/workspace/lamp_dial.h"

namespace sonoskin::ui {
namespace {

constexpr double kLeastDistance = 1, kMostDistance = 1000;

double tenths(double value) { return std::round(10 * value) / 10; }

void moveLamp(const glm::vec2& place, Workspace& w, const PaneInput& input) {
  const glm::vec2 at = (place - 0.5f * input.size) / dialRadius(input);
  const glm::vec2 angles = lightAngles(dialDirection({at.x, -at.y}, w.view.camera), homeOf(w));
  Parameters p = w.session.parameters();
  p.light.azimuth = tenths(double(angles.x));
  p.light.elevation = tenths(double(angles.y));
  w.session.edit(p);
}

void moveDivider(Workspace& w, const PaneInput& input) {
  w.view.skin.divider = std::clamp(input.mouse.x / input.size.x, 0.02f, 0.98f);
}

// The step for undo is made when the mouse moves on.
void turnWheel(ToolState& state, Workspace& w, float notches) {
  Parameters p = w.session.parameters();
  const double factor = std::pow(1.1, -double(notches));
  p.light.distance = std::clamp(tenths(factor * p.light.distance), kLeastDistance, kMostDistance);
  w.session.edit(p);
  state.lamp.turning = true;
}

void take(ToolState& state, const Workspace& w, const PaneInput& input) {
  const bool onLamp = isOnLamp(w, input);
  if (!onLamp && !isOnDivider(w, input)) return;
  state.held = Tool::lamp;
  state.lamp.divider = !onLamp;
  state.lamp.offset = lampPlace(w, input) - input.mouse;
}

}  // namespace

PaneInput useLampTool(ToolState& state, Workspace& w, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  if (input.pressed && holdsLeft(input) && !input.shift) take(state, w, input);
  const bool onLamp = isOnLamp(w, input);
  if (state.lamp.turning && (!onLamp || input.pressed)) {
    w.session.commitEdit();
    state.lamp.turning = false;
  }
  if (onLamp && input.wheel != 0 && w.session.parameters().light.kind != LightKind::far) {
    turnWheel(state, w, input.wheel);
    PaneInput left = withoutButton(input);
    left.wheel = 0;
    return left;
  }
  if (!state.held) return input;
  if (input.moved != glm::vec2(0)) {
    if (state.lamp.divider)
      moveDivider(w, input);
    else
      moveLamp(input.mouse + state.lamp.offset, w, input);
  }
  return withoutButton(input);
}

void letGoLampTool(ToolState& state, Workspace& w, const ToolPane&) {
  if (!state.lamp.divider) w.session.commitEdit();
}

}  // namespace sonoskin::ui
