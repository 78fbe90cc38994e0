#include "app/views/plane_cut.h"

#include <algorithm>
#include <cmath>

#include "render/camera.h"

namespace sonoskin::ui {

std::vector<glm::vec3> cutCorners(const std::array<glm::vec3, 8>& corners, const ClipPlane& plane) {
  std::vector<glm::vec3> cut;
  for (std::size_t n = 0; n < 8; ++n)
    for (const std::size_t axis : {1, 2, 4}) {
      if (n & axis) continue;
      const glm::vec3 &a = corners[n], &b = corners[n | axis];
      const float toA = glm::dot(plane.normal, a) + plane.offset,
                  toB = glm::dot(plane.normal, b) + plane.offset;
      if (toA * toB < 0) cut.push_back(glm::mix(a, b, toA / (toA - toB)));
    }
  glm::vec3 middle(0);
  for (const glm::vec3& corner : cut) middle += corner / float(cut.size());
  const glm::vec3 u = rightOf(plane.normal, {0.3f, 0.5f, 0.8f}), v = glm::cross(plane.normal, u);
  std::ranges::sort(cut, {}, [&](const glm::vec3& corner) {
    return std::atan2(glm::dot(corner - middle, v), glm::dot(corner - middle, u));
  });
  return cut;
}

}  // namespace sonoskin::ui
