#include "app/views/tools.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

const ImU32 kErase = IM_COL32(240, 90, 110, 255), kBringBack = IM_COL32(120, 220, 140, 255);

bool bringsBack(const PaneInput& input) { return input.control || input.shift; }

}  // namespace

PaneInput useEraser(ToolState& state, Workspace& w, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  if (!holdsLeft(input)) return input;
  const auto brushTo = [&](const glm::vec2& mouse) {
    const glm::dvec3 at = pane.slice->frame.toWorld(glm::dvec2(mouse));
    w.session.erase({state.held ? state.brushAt : at, at, w.view.brushRadius, !bringsBack(input)});
    state.brushAt = at;
    state.held = Tool::eraser;
  };
  if (input.pressed || (state.held && input.moved != glm::vec2(0))) {
    if (state.held)
      for (const glm::vec2& at : w.view.trail) brushTo(at - input.corner);
    brushTo(input.mouse);
  }
  return withoutButton(input);
}

void letGoEraser(ToolState&, Workspace& w, const ToolPane&) { w.session.commitEdit(); }

void drawEraser(const ToolState& state, const Workspace& w, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  if (!input.hovered && !state.held) return;
  const ImVec2 middle{input.corner.x + input.mouse.x, input.corner.y + input.mouse.y};
  const auto radius = float(w.view.brushRadius / pane.slice->frame.millimetresPerPixel());
  ImGui::GetWindowDrawList()->AddCircle(middle, radius, bringsBack(input) ? kBringBack : kErase, 0,
                                        1.5f * unit());
}

}  // namespace sonoskin::ui
