#include "app/views/mesh_contour.h"

#include <cmath>

#include "app/widgets/theme.h"

namespace sonoskin::ui {

void MeshContour::update(const std::shared_ptr<const Mesh>& mesh, const SliceFrame& frame) {
  constexpr double kSame = 1e-6;  // mm
  const glm::dvec3 n = glm::normalize(glm::cross(frame.right, frame.down));
  const bool another = from.see({mesh});
  const bool moved = glm::distance(n, normal) > kSame || std::abs(glm::dot(frame.corner - point, n)) > kSame;
  if (!another && !moved) return;
  point = frame.corner;
  normal = n;
  segments = mesh ? planeSection(*mesh, point, normal) : std::vector<Segment>();
}

void drawContour(const MeshContour& contour, const SliceFrame& frame, const PaneInput& pane) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = IM_COL32(242, 120, 200, 255);
  const auto at = [&](const glm::vec3& world) {
    const glm::vec2 p = pane.corner + glm::vec2(frame.toPixel(glm::dvec3(world)));
    return ImVec2(p.x, p.y);
  };
  for (const Segment& s : contour.segments) list.AddLine(at(s[0]), at(s[1]), colour, 1.3f * unit());
}

}  // namespace sonoskin::ui
