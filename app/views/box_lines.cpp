#include "app/views/box_lines.h"

#include <array>
#include <optional>

#include "app/document/crop_box.h"
#include "app/views/projection.h"
#include "app/views/scene.h"
#include "app/widgets/theme.h"

namespace sonoskin::ui {
namespace {

// The box's corners; bits 0, 1, 2 of the number: at the high end of i, j, k.
std::array<glm::vec3, 8> cornersOf(const RegionOptions& options, const Geometry& g) {
  const auto ends = boxCorners(options, g);
  const glm::dvec3 low = g.toIndex(ends[0]), high = g.toIndex(ends[1]);
  std::array<glm::vec3, 8> corners;
  for (int n = 0; n < 8; ++n)
    corners[std::size_t(n)] = glm::vec3(g.toWorld(glm::mix(low, high, glm::bvec3(n & 1, n & 2, n & 4))));
  return corners;
}

}  // namespace

bool showsBoxInSpace(const Workspace& w) {
  return w.view.cropBox && (!showsMesh(w) || w.step == Step::region);
}

void drawBoxLines(const PaneInput& pane, const Workspace& workspace) {
  const Camera& camera = workspace.view.camera;
  const auto corners =
      cornersOf(workspace.session.parameters().region, workspace.session.scan().volume->geometry);
  std::array<std::optional<glm::vec2>, 8> seen;
  for (std::size_t n = 0; n < 8; ++n) seen[n] = seenAt(corners[n], camera, pane);
  ImVec4 colour = kAccent;
  colour.w = 0.55f;
  for (std::size_t n = 0; n < 8; ++n)
    for (const std::size_t axis : {1, 2, 4}) {
      const std::size_t m = n | axis;
      if (m == n || !seen[n] || !seen[m]) continue;
      ImGui::GetWindowDrawList()->AddLine({seen[n]->x, seen[n]->y}, {seen[m]->x, seen[m]->y},
                                          ImGui::GetColorU32(colour), unit());
    }
}

}  // namespace sonoskin::ui
