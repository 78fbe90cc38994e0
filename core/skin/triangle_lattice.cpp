#include "core/skin/triangle_lattice.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {

TriangleLattice::TriangleLattice(const Mesh& mesh, double longest)
    : positions_(mesh.positions), normals_(mesh.normals) {
  constexpr double kMostParts = 128;
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const double side = double(std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)}));
    const auto n = std::uint32_t(std::clamp(std::ceil(side / longest), 1.0, kMostParts));
    parts_.push_back(n);
    first_.push_back(std::uint32_t(positions_.size()));
    if (n == 1) continue;
    for (std::uint32_t v = 0; v <= n; ++v)
      for (std::uint32_t u = 0; u + v <= n; ++u) {
        const glm::vec3 w(float(n - u - v) / float(n), float(u) / float(n), float(v) / float(n));
        positions_.push_back(w.x * a + w.y * b + w.z * c);
        const glm::vec3 normal =
            w.x * mesh.normals[t[0]] + w.y * mesh.normals[t[1]] + w.z * mesh.normals[t[2]];
        const float length = glm::length(normal);
        normals_.push_back(length > 0 ? normal / length : mesh.normals[t[0]]);
      }
  }
}

}  // namespace sonoskin
