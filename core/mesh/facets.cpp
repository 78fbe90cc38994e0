#include "core/mesh/facets.h"

#include <numeric>

namespace sonoskin {

Facets::Facets(const Mesh& surface, const Progress& progress)
    : mesh(surface), normal(surface.triangles.size()), centre(surface.triangles.size()) {
  progress.update(0);
  opposite = oppositeHalfEdges(mesh.triangles, mesh.positions.size());
  parallelItems(
      size(), kFacetsPerTask,
      [&](std::size_t t) {
        const auto& [i, j, k] = mesh.triangles[t];
        const glm::vec3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
        normal[t] = 0.5f * glm::cross(b - a, c - a);
        centre[t] = (a + b + c) / 3.f;
      },
      progress);
}

double Facets::area() const {
  double sum = 0;
  for (const glm::vec3& n : normal) sum += double(glm::length(n));
  return sum;
}

Groups::Groups(const std::vector<std::uint32_t>& groupOf, std::size_t groups)
    : start(groups + 2, 0), items(groupOf.size()) {
  for (const std::uint32_t g : groupOf) ++start[g + 2];
  std::partial_sum(start.begin(), start.end(), start.begin());
  for (std::uint32_t i = 0; i < groupOf.size(); ++i) items[start[groupOf[i] + 1]++] = i;
  start.pop_back();
}

}  // namespace sonoskin
