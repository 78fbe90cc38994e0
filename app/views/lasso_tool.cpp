#include <glm/gtc/matrix_access.hpp>

#include "app/texts/texts.h"
#include "app/views/projection.h"
#include "app/views/scene.h"
#include "app/views/tools.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

constexpr std::size_t kMostPoints = 20000;

// How a slice shows the world; depth is the distance from it.
glm::dmat4 pictureOf(const SliceFrame& frame) {
  const auto row = [&](const glm::dvec3& along) { return glm::dvec4(along, -glm::dot(along, frame.corner)); };
  glm::dmat4 m(0);
  m = glm::row(m, 0, row(frame.right / glm::dot(frame.right, frame.right)));
  m = glm::row(m, 1, row(frame.down / glm::dot(frame.down, frame.down)));
  m = glm::row(m, 2, row(glm::normalize(glm::cross(frame.right, frame.down))));
  return glm::row(m, 3, glm::dvec4(0, 0, 0, 1));
}

// How the camera shows it; depth is that along the view, from the eye.
glm::dmat4 pictureOf(const Camera& camera, const PaneInput& pane) {
  const auto row = [&](const glm::dvec3& along) {
    return glm::dvec4(along, -glm::dot(along, glm::dvec3(camera.eye())));
  };
  const double scale = double(pixelsPerTangent(camera, pane));
  const glm::dvec4 depth = row(camera.forward);
  glm::dmat4 m(0);
  m = glm::row(m, 0, scale * row(camera.right()) + 0.5 * double(pane.size.x) * depth);
  m = glm::row(m, 1, -scale * row(camera.up) + 0.5 * double(pane.size.y) * depth);
  m = glm::row(m, 2, depth);
  return glm::row(m, 3, depth);
}

void limitDepth(Lasso& lasso, const Workspace& w, const ToolPane& pane) {
  const double depth = w.view.lassoDepth;
  if (depth <= 0) return;
  if (pane.slice) {
    lasso.from = -depth;
    lasso.to = depth;
  } else {
    Lasso within = lasso;
    within.outside = false;
    lasso.to = nearestWithin(*shownVolume(w), shownLevel(w.view, w.session.results()), within) + depth;
  }
}

}  // namespace

PaneInput useLasso(ToolState& state, Workspace& w, const ToolPane& pane) {
  const PaneInput& input = pane.input;
  if (!holdsLeft(input)) return input;
  if (input.pressed) {
    state.outline = {input.mouse};
    state.stroke = {input.mouse, input.mouse, input.control, input.shift};
    state.held = Tool::lasso;
  } else if (state.held && state.outline.size() < kMostPoints) {
    for (const glm::vec2& at : w.view.trail) state.outline.push_back(at - input.corner);
    state.outline.push_back(input.mouse);
  }
  return withoutButton(input);
}

void letGoLasso(ToolState& state, Workspace& w, const ToolPane& pane) {
  const std::vector<glm::vec2> drawn = std::exchange(state.outline, {});
  if (!isChosen(w.view, Tool::lasso)) return;  // put away while it was drawn
  if (w.session.activity().blocking) {
    w.toasts.add(tr("Wait until the surface is there, or cancel it, before something is cut out."), false);
    return;
  }
  Lasso lasso{.outline = {drawn.begin(), drawn.end()},
              .toPicture = pane.slice ? pictureOf(pane.slice->frame) : pictureOf(w.view.camera, pane.input),
              .outside = state.stroke.shift,
              .mark = !state.stroke.control};
  limitDepth(lasso, w, pane);
  w.session.erase(lasso);
  w.session.commitEdit();
}

void drawLasso(const ToolState& state, const Workspace&, const ToolPane& pane) {
  if (!state.held)
    shadedLines(pane.input, {tr("draw around what is to go   Ctrl: bring back"),
                             tr("Shift: keep that alone   Esc: done")});
  if (!state.held || state.outline.size() < 2) return;
  std::vector<ImVec2> points;
  for (const glm::vec2& p : state.outline)
    points.push_back({pane.input.corner.x + p.x, pane.input.corner.y + p.y});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int count = int(points.size());
  list.AddPolyline(points.data(), count, IM_COL32(0, 0, 0, 170), ImDrawFlags_None, 4 * unit());
  const ImU32 colour = state.stroke.control ? IM_COL32(120, 220, 140, 255) : IM_COL32(240, 90, 110, 255);
  list.AddPolyline(points.data(), count, colour, ImDrawFlags_None, 1.5f * unit());
  list.AddLine(points.back(), points.front(), colour, unit());
}

}  // namespace sonoskin::ui
