#include "core/mesh/search/ray_hit.h"

#include <cmath>

namespace sonoskin {

// Each triangle's plane and two of its coordinates.                                        [Moller, Trumbore 1997]
std::optional<RayHit> firstTriangle(const Mesh& mesh, const glm::vec3& origin, const glm::vec3& direction) {
  std::optional<RayHit> nearest;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const glm::vec3& a = mesh.positions[t[0]];
    const glm::vec3 ab = mesh.positions[t[1]] - a, ac = mesh.positions[t[2]] - a;
    const glm::vec3 p = glm::cross(direction, ac);
    const float det = glm::dot(ab, p);
    if (det == 0) continue;
    const glm::vec3 fromA = origin - a, q = glm::cross(fromA, ab);
    const float u = glm::dot(fromA, p) / det, v = glm::dot(direction, q) / det;
    const float distance = glm::dot(ac, q) / det;
    if (u < 0 || v < 0 || u + v > 1 || distance <= 0) continue;
    if (!nearest || distance < nearest->distance) nearest = {distance, i};
  }
  return nearest;
}

std::optional<float> firstHit(const Mesh& mesh, const glm::vec3& origin, const glm::vec3& direction) {
  const std::optional<RayHit> hit = firstTriangle(mesh, origin, direction);
  return hit ? std::optional(hit->distance) : std::nullopt;
}

}  // namespace sonoskin
