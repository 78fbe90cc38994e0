#include <fmt/format.h>

#include <algorithm>

#include "app/document/part_edits.h"
#include "app/texts/texts.h"
#include "app/views/projection.h"
#include "app/views/scene.h"
#include "app/views/tools.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

constexpr float kClickReach = 4, kLeastStroke = 12;  // pixels at content scale 1

std::optional<PartPick> pickAt(const Workspace& w, const PaneInput& pane, const glm::vec2& mouse) {
  const Camera& camera = w.view.camera;
  return pickPart(w.session.results(), camera.eye(), rayThrough(mouse, camera, pane));
}

std::string areaOf(const Workspace& w, std::uint32_t part) {
  const double area = w.session.results().parts->parts.parts[part].area;
  return fmt::format("{:.1f} cm²", area / 100);
}

void clickPart(const ToolState::Stroke& stroke, Workspace& w, const PaneInput& input) {
  const auto pick = pickAt(w, input, stroke.from);
  if (!pick) return;
  const Results& results = w.session.results();
  const MeshOptions& options = w.session.parameters().mesh;
  if (stroke.shift) {
    w.session.editParts(partAlone(results, options, *pick));
    w.toasts.add(tr("This part alone. Ctrl+Z: as before."), false);
    return;
  }
  const bool kept = (*results.verdicts)[pick->part].kept;
  const auto changed = togglePart(results, options, *pick);
  if (!changed) {
    w.toasts.add(tr("This is the last part that is left."), false);
    return;
  }
  const char* told =
      kept ? "A part of {} taken away. Ctrl+Z: as before." : "A part of {} brought back. Ctrl+Z: as before.";
  w.toasts.add(trf(told, areaOf(w, pick->part)), false);
  w.session.editParts(*changed);
}

void splitAlong(const ToolState::Stroke& line, Workspace& w, const PaneInput& input) {
  if (glm::distance(line.from, line.to) < kLeastStroke * unit()) return;
  const Camera& camera = w.view.camera;
  const auto rayAt = [&](float t) { return rayThrough(glm::mix(line.from, line.to, t), camera, input); };
  const auto stroke = strokeAcross(w.session.results(), camera.eye(), rayAt);
  if (!stroke) {
    w.toasts.add(tr("There is no part below the line: draw it across one."), false);
    return;
  }
  w.session.editParts(addStroke(w.session.parameters().mesh, *stroke));
  w.toasts.add(tr("Split along the line. Ctrl+Z: as before."), false);
}

}  // namespace

PaneInput usePartTool(ToolState& state, Workspace&, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  if (input.pressed && holdsLeft(input)) {
    state.held = Tool::parts;
    state.stroke = {input.mouse, input.mouse, input.control, input.shift};
  }
  if (!state.held) return input;
  state.stroke.to = input.mouse;
  if (state.stroke.control) return withoutButton(input);
  // A click that moves is a turn of the camera.
  if (glm::distance(state.stroke.from, state.stroke.to) > kClickReach * unit()) state.held.reset();
  return input;
}

void letGoPartTool(ToolState& state, Workspace& w, const ToolPane& pane) {
  if (w.session.activity().blocking || !showsParts(w)) return;
  if (state.stroke.control)
    splitAlong(state.stroke, w, pane.input);
  else
    clickPart(state.stroke, w, pane.input);
}

void drawPartTool(const ToolState& state, const Workspace&, const ToolPane& pane) {
  if (!state.held || !state.stroke.control) return;
  const glm::vec2 a = pane.input.corner + state.stroke.from, b = pane.input.corner + state.stroke.to;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({a.x, a.y}, {b.x, b.y}, IM_COL32(0, 0, 0, 170), 4 * unit());
  list.AddLine({a.x, a.y}, {b.x, b.y}, IM_COL32(255, 255, 255, 255), 1.5f * unit());
}

std::string partCaption(const Workspace& workspace) {
  const auto& verdicts = *workspace.session.results().verdicts;
  const auto kept =
      std::count_if(verdicts.begin(), verdicts.end(), [](const PartVerdict& v) { return v.kept; });
  return trf("{} of {} parts shown", kept, verdicts.size());
}

void drawPartHints(const PaneInput& pane) {
  shadedLines(pane, {tr("click: off and on   Shift+click: alone"), tr("Ctrl+line: split   Esc: done")});
}

}  // namespace sonoskin::ui
