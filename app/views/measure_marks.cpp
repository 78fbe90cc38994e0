#include "app/views/measure_marks.h"

#include <algorithm>
#include <vector>

#include "app/views/projection.h"
#include "app/widgets/theme.h"
#include "app/widgets/widget_rects.h"

namespace sonoskin::ui {
namespace {

const ImU32 kLine = IM_COL32(255, 221, 87, 255), kBehind = IM_COL32(0, 0, 0, 150);
const ImVec4 kValue{1.0f, 0.87f, 0.34f, 1};

void line(const glm::vec2& a, const glm::vec2& b) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({a.x, a.y}, {b.x, b.y}, kBehind, 3 * unit());
  list.AddLine({a.x, a.y}, {b.x, b.y}, kLine, 1.4f * unit());
}

// A measure on the screen: its border or sides, its marks, and its value beside the last of them.
void drawMeasure(const Measure& measure, const std::vector<glm::vec2>& at, bool closed) {
  for (std::size_t n = 0; n + 1 < at.size(); ++n) line(at[n], at[n + 1]);
  if (closed && at.size() > 2) line(at.back(), at.front());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const glm::vec2& p : at) list.AddCircleFilled({p.x, p.y}, 2.6f * unit(), kLine);
  const std::string text = measureText(measure);
  if (text.empty() || at.empty()) return;
  const bool angle = measure.kind == MeasureKind::angle;
  const glm::vec2 place = (angle ? at[1] : at.back()) + glm::vec2(9, -6) * unit();
  shadedText({place.x, place.y}, kValue, text);
}

// With what the mouse would add to it.
Measure withMouse(Measure measure, const glm::dvec3& mouse) {
  if (!isFull(measure)) measure.marks.push_back(mouse);
  return measure;
}

}  // namespace

bool isInSlice(const glm::dvec3& mark, const SliceFrame& frame, const Geometry& geometry) {
  const glm::dvec3 n = glm::normalize(glm::cross(frame.right, frame.down));
  const double slice = glm::length(glm::transpose(geometry.direction) * n * geometry.spacing);
  return std::abs(glm::dot(mark - frame.corner, n)) <= 0.51 * slice;
}

void drawMeasuresInSlice(const PaneInput& pane, const Workspace& w, const SliceFrame& frame) {
  const Geometry& g = w.session.scan().volume->geometry;
  const auto draw = [&](const Measure& measure, bool closed) {
    std::vector<glm::vec2> at;
    for (const glm::dvec3& mark : measure.marks) {
      if (!isInSlice(mark, frame, g)) return;
      at.push_back(pane.corner + glm::vec2(frame.toPixel(mark)));
    }
    drawMeasure(measure, at, closed);
  };
  for (const Measure& measure : w.view.measures) draw(measure, measure.kind == MeasureKind::area);
  if (!w.view.measureBegun) return;
  const Measure& begun = *w.view.measureBegun;
  draw(pane.hovered ? withMouse(begun, frame.toWorld(glm::dvec2(pane.mouse))) : begun,
       begun.kind == MeasureKind::area);
}

void drawMeasuresInSpace(const PaneInput& pane, const Workspace& w) {
  for (const Measure& measure : w.view.measures) {
    std::vector<glm::vec2> at;
    for (const glm::dvec3& mark : measure.marks)
      if (const auto seen = seenAt(glm::vec3(mark), w.view.camera, pane)) at.push_back(*seen);
    if (at.size() == measure.marks.size()) drawMeasure(measure, at, measure.kind == MeasureKind::area);
  }
}

}  // namespace sonoskin::ui
