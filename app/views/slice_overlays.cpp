#include "app/views/slice_overlays.h"

#include <fmt/format.h>

#include <cmath>

#include "app/texts/texts.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

// Points within half a slice of the plane.
void drawPoints(const Workspace& w, const SliceFrame& frame, const PaneInput& pane) {
  const auto& points = w.session.results().points;
  if (!points) return;
  const Geometry& g = w.session.scan().volume->geometry;
  const glm::dvec3 n = glm::normalize(glm::cross(frame.right, frame.down));
  const glm::dvec3 along = glm::transpose(g.direction) * n;
  const double half = 0.5 * glm::length(along * g.spacing);
  const double offset = glm::dot(frame.corner, n);
  const float r = 1.4f * unit();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const glm::vec3& p : points->positions) {
    const glm::dvec3 world(p);
    if (std::abs(glm::dot(world, n) - offset) > half) continue;
    const glm::vec2 at = pane.corner + glm::vec2(frame.toPixel(world));
    list.AddRectFilled({at.x - r, at.y - r}, {at.x + r, at.y + r}, IM_COL32(90, 220, 240, 230));
  }
}

// "L 12.3" of a patient, "12.3" of a scanner.
std::string coordinate(bool isPatient, int axis, double mm) {
  if (!isPatient) return fmt::format("{:.1f}", mm);
  return fmt::format("{} {:.1f}", "RLAPIS"[2 * axis + (mm > 0 ? 1 : 0)], std::abs(mm));
}

}  // namespace

void drawOverlays(SliceWindow& window, const Workspace& w, const SliceFrame& frame, const PaneInput& pane) {
  if (w.view.slicePoints) drawPoints(w, frame, pane);
  if (!w.view.meshContour) return;
  window.contour.update(w.session.results().mesh, frame);
  drawContour(window.contour, frame, pane);
}

std::string pointerText(const Workspace& w, const SliceFrame& frame, const PaneInput& pane) {
  const Scan& scan = w.session.scan();
  const Geometry& g = scan.volume->geometry;
  const glm::dvec3 world = frame.toWorld(glm::dvec2(pane.mouse));
  const glm::ivec3 v(glm::floor(g.toIndex(world) + 0.5));
  if (glm::any(glm::lessThan(v, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(v, g.dims))) return {};
  const bool isPatient = w.viewFrame().isPatient;
  const double value = double(scan.volume->at(v.x, v.y, v.z));
  const double original = scan.originalMin + value * (scan.originalMax - scan.originalMin);
  const std::string place = fmt::format("{}  {}  {} mm", coordinate(isPatient, 0, world.x),
                                        coordinate(isPatient, 1, world.y), coordinate(isPatient, 2, world.z));
  return fmt::format("{}   {} {:.{}f} ({:.2f})", place, tr("value"), original,
                     scan.originalMax - scan.originalMin > 20 ? 0 : 2, value);
}

}  // namespace sonoskin::ui
