#include "core/mesh/plane_section.h"

#include <cstddef>

namespace sonoskin {

std::vector<Segment> planeSection(const Mesh& mesh, const glm::dvec3& point, const glm::dvec3& normal) {
  const glm::vec3 n(normal);
  const float offset = float(glm::dot(point, normal));
  std::vector<float> heights(mesh.positions.size());
  for (std::size_t v = 0; v < heights.size(); ++v) heights[v] = glm::dot(mesh.positions[v], n) - offset;
  std::vector<Segment> segments;
  for (const Triangle& triangle : mesh.triangles) {
    Segment segment;
    std::size_t ends = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t a = triangle[corner], b = triangle[(corner + 1) % 3];
      if ((heights[a] > 0) == (heights[b] > 0)) continue;
      const float share = heights[a] / (heights[a] - heights[b]);
      segment[ends++] = glm::mix(mesh.positions[a], mesh.positions[b], share);
    }
    if (ends == 2) segments.push_back(segment);
  }
  return segments;
}

}  // namespace sonoskin
