#include "app/views/part_tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/document/part_edits.h"
#include "app/views/projection.h"
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

void clickPart(const PartTools& tools, Workspace& w, const PaneInput& pane) {
  const auto pick = pickAt(w, pane, tools.from);
  if (!pick) return;
  const Results& results = w.session.results();
  const MeshOptions& options = w.session.parameters().mesh;
  if (tools.alone) {
    w.session.editParts(partAlone(results, options, *pick));
    w.toasts.add("This part alone. Ctrl+Z: as before.", false);
    return;
  }
  const bool kept = (*results.verdicts)[pick->part].kept;
  const auto changed = togglePart(results, options, *pick);
  if (!changed) {
    w.toasts.add("This is the last part that is left.", false);
    return;
  }
  w.toasts.add(fmt::format("A part of {} {}. Ctrl+Z: as before.", areaOf(w, pick->part),
                           kept ? "taken away" : "brought back"),
               false);
  w.session.editParts(*changed);
}

void splitAlong(const PartTools& tools, Workspace& w, const PaneInput& pane) {
  if (glm::distance(tools.from, tools.to) < kLeastStroke * unit()) return;
  const Camera& camera = w.view.camera;
  const auto rayAt = [&](float t) { return rayThrough(glm::mix(tools.from, tools.to, t), camera, pane); };
  const auto stroke = strokeAcross(w.session.results(), camera.eye(), rayAt);
  if (!stroke) {
    w.toasts.add("There is no part below the line: draw it across one.", false);
    return;
  }
  w.session.editParts(addStroke(w.session.parameters().mesh, *stroke));
  w.toasts.add("Split along the line. Ctrl+Z: as before.", false);
}

void letGo(PartTools& tools, Workspace& w, const PaneInput& pane) {
  const PartTools::Held held = std::exchange(tools.held, PartTools::Held::nothing);
  w.view.toolHeld = false;
  if (w.session.activity().blocking) return;
  if (held == PartTools::Held::click) clickPart(tools, w, pane);
  if (held == PartTools::Held::stroke) splitAlong(tools, w, pane);
}

}  // namespace

bool showsParts(const Workspace& workspace) {
  return workspace.view.parts && workspace.view.content == SpaceContent::mesh &&
         hasParts(workspace.session.results());
}

PaneInput usePartTools(PartTools& tools, Workspace& workspace, const PaneInput& pane) {
  const bool left = pane.button == ImGuiMouseButton_Left;
  if (pane.pressed && left) {
    tools = {pane.control ? PartTools::Held::stroke : PartTools::Held::click, pane.mouse, pane.mouse,
             pane.shift};
    workspace.view.toolHeld = tools.held == PartTools::Held::stroke;
  }
  if (tools.held == PartTools::Held::nothing) return pane;
  if (!left) {
    letGo(tools, workspace, pane);
    return pane;
  }
  tools.to = pane.mouse;
  if (tools.held == PartTools::Held::click) {
    if (glm::distance(tools.from, tools.to) > kClickReach * unit()) tools.held = PartTools::Held::nothing;
    return pane;
  }
  PaneInput rest = pane;
  rest.button = -1;
  return rest;
}

void drawPartMarks(const PartTools& tools, const PaneInput& pane) {
  if (tools.held != PartTools::Held::stroke) return;
  const glm::vec2 a = pane.corner + tools.from, b = pane.corner + tools.to;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({a.x, a.y}, {b.x, b.y}, IM_COL32(0, 0, 0, 170), 4 * unit());
  list.AddLine({a.x, a.y}, {b.x, b.y}, IM_COL32(255, 255, 255, 255), 1.5f * unit());
}

std::string partCaption(const Workspace& workspace) {
  const auto& verdicts = *workspace.session.results().verdicts;
  const auto kept =
      std::count_if(verdicts.begin(), verdicts.end(), [](const PartVerdict& v) { return v.kept; });
  return fmt::format(
      "{} of {} parts shown   click: off and on   Shift+click: alone   Ctrl+line: split   Esc: done", kept,
      verdicts.size());
}

}  // namespace sonoskin::ui
