#include "app/views/oblique_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/views/plane_cut.h"
#include "app/views/projection.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

constexpr float kReach = 10, kRadius = 4.5f;            // units: to the mouse that takes an end; of an end
constexpr float kAside = 36, kAbove = 60, kBelow = 52;  // of ends from the view's sides
constexpr float kFreeOfLines = 10;                      // around the cross-hair
constexpr float kFar = 20000;                           // pixels, beyond any view
constexpr double kParallel = 0.02;                      // sine

// Line: in a slice's picture, pixels from the view's upper left corner.
struct Line {
  glm::vec2 through{0}, along{1, 0};
};

// Where a plane through the cross-hair meets a slice.
std::optional<Line> lineIn(const ToolPane& pane, const glm::dvec3& cursor, const glm::dvec3& normal) {
  const SliceFrame& frame = pane.slice->frame;
  const glm::dvec3 along = glm::cross(glm::normalize(glm::cross(frame.right, frame.down)), normal);
  if (glm::length(along) < kParallel) return std::nullopt;
  const glm::dvec2 at = frame.toPixel(cursor);
  return Line{glm::vec2(at), glm::vec2(glm::normalize(frame.toPixel(cursor + along) - at))};
}

glm::dvec3 normalOf(const Workspace& w, Plane plane) {
  return w.session.scan().volume->geometry.direction[w.view.planes[plane].across];
}

bool showsOblique(const Workspace& w) { return w.settings.layout.layout == Layout::oblique; }

void drawLine(const PaneInput& pane, const Line& line, const ImVec4& colour, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const float side : {-1.f, 1.f}) {
    const glm::vec2 near = pane.corner + line.through + side * kFreeOfLines * unit() * line.along;
    const glm::vec2 far = pane.corner + line.through + side * kFar * line.along;
    list.AddLine({near.x, near.y}, {far.x, far.y}, ImGui::GetColorU32(colour), width * unit());
  }
}

void drawThreePlanes(const Workspace& w, const ToolPane& pane) {
  for (const Plane plane : kPlanes) {
    const auto line = lineIn(pane, w.view.cursor, normalOf(w, plane));
    const glm::vec3 c = planeColour(plane);
    if (line) drawLine(pane.input, *line, {c.r, c.g, c.b, 0.7f}, 1);
  }
}

void drawEnds(const ToolState& state, const Workspace& w, const ToolPane& pane) {
  const auto ends = obliqueEnds(w, pane);
  if (!ends) return;
  const bool held = state.held == Tool::oblique;
  const auto under = pane.input.hovered && !state.held ? endUnderMouse(w, pane) : std::nullopt;
  if (held || under) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t n = 0; n < 2; ++n) {
    const glm::vec2 at = pane.input.corner + (*ends)[n];
    const float r = (held || under == n ? 1.5f : 1) * kRadius * unit();
    list.AddCircleFilled({at.x, at.y}, r, ImGui::GetColorU32(kOblique));
    list.AddCircle({at.x, at.y}, r, IM_COL32(10, 12, 15, 220), 0, 1.2f * unit());
    constexpr std::array<const char*, 3> kNames{"sagittal", "coronal", "axial"};
    notePlace(fmt::format("oblique.{}.{}", kNames[std::size_t(*pane.slice->plane)], n), at, kRadius * unit());
  }
}

}  // namespace

std::optional<std::array<glm::vec2, 2>> obliqueEnds(const Workspace& w, const ToolPane& pane) {
  const auto line = lineIn(pane, w.view.cursor, w.view.oblique.directions.normal());
  if (!line) return std::nullopt;
  const glm::vec2 least(kAside * unit(), kAbove * unit()),
      most = pane.input.size - glm::vec2(kAside, kBelow) * unit();
  float from = -kFar, to = kFar;
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(line->along[axis]) < 1e-6f) continue;
    const float a = (least[axis] - line->through[axis]) / line->along[axis],
                b = (most[axis] - line->through[axis]) / line->along[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (to - from < 4 * kRadius * unit()) return std::nullopt;
  return std::array{line->through + from * line->along, line->through + to * line->along};
}

std::optional<std::size_t> endUnderMouse(const Workspace& w, const ToolPane& pane) {
  const auto ends = obliqueEnds(w, pane);
  for (std::size_t n = 0; ends && n < 2; ++n)
    if (glm::distance((*ends)[n], pane.input.mouse) < kReach * unit()) return n;
  return std::nullopt;
}

void drawPlaneLines(const ToolState& state, const Workspace& w, const ToolPane& pane) {
  if (!pane.slice->plane) return drawThreePlanes(w, pane);
  if (!showsOblique(w)) return;
  if (const auto line = lineIn(pane, w.view.cursor, w.view.oblique.directions.normal()))
    drawLine(pane.input, *line, kOblique, 1.3f);
  drawEnds(state, w, pane);
}

void drawObliqueInSpace(const PaneInput& pane, const Workspace& w) {
  if (!showsOblique(w)) return;
  const Geometry& g = w.session.scan().volume->geometry;
  std::array<glm::vec3, 8> corners;
  for (int n = 0; n < 8; ++n)
    corners[std::size_t(n)] = glm::vec3(
        g.toWorld(glm::mix(glm::dvec3(-0.5), glm::dvec3(g.dims) - 0.5, glm::bvec3(n & 1, n & 2, n & 4))));
  const ClipPlane plane =
      clipPlaneThrough(glm::vec3(w.view.cursor), glm::vec3(w.view.oblique.directions.normal()));
  std::vector<ImVec2> border;
  for (const glm::vec3& corner : cutCorners(corners, plane)) {
    const auto seen = seenAt(corner, w.view.camera, pane);
    if (!seen) return;
    border.emplace_back(seen->x, seen->y);
  }
  ImVec4 colour = kOblique;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  colour.w = 0.06f;
  list.AddConvexPolyFilled(border.data(), int(border.size()), ImGui::GetColorU32(colour));
  colour.w = 0.8f;
  list.AddPolyline(border.data(), int(border.size()), ImGui::GetColorU32(colour), ImDrawFlags_Closed,
                   1.3f * unit());
}

}  // namespace sonoskin::ui
