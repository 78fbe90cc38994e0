#include "core/mesh/search/signed_distance.h"

#include <cmath>

#include "core/mesh/half_edges.h"

namespace sonoskin {
namespace {

glm::vec3 unit(const glm::vec3& v) {
  const float length = glm::length(v);
  return length > 0 ? v / length : glm::vec3(0);
}

}  // namespace

SignedDistance::SignedDistance(const Mesh& mesh)
    : mesh_(mesh),
      tree_(mesh),
      vertexNormals_(mesh.positions.size(), glm::vec3(0)),
      opposite_(oppositeHalfEdges(mesh.triangles, mesh.positions.size())),
      isBorder_(mesh.positions.size(), false) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    const auto p = [&](std::size_t i) { return mesh.positions[c[i % 3]]; };
    faceNormals_.push_back(unit(glm::cross(p(1) - p(0), p(2) - p(0))));
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3 a = unit(p(i + 1) - p(i)), b = unit(p(i + 2) - p(i));
      vertexNormals_[c[i]] += std::acos(glm::clamp(glm::dot(a, b), -1.f, 1.f)) * faceNormals_.back();
      if (opposite_[3 * t + i] == kNoHalfEdge) isBorder_[c[i]] = isBorder_[c[(i + 1) % 3]] = true;
    }
  }
  for (glm::vec3& n : vertexNormals_) n = unit(n);
}

SignedDistance::Place SignedDistance::at(const glm::vec3& query, std::uint32_t guess) const {
  const TriangleTree::Hit hit = tree_.nearest(query, guess);
  const Triangle& t = mesh_.triangles[hit.triangle];
  const glm::vec3& w = hit.place.weights;
  const int zeros = int(w.x == 0) + int(w.y == 0) + int(w.z == 0);
  glm::vec3 normal = faceNormals_[hit.triangle];
  bool isBeyond = false;
  if (zeros == 2) {
    const std::uint32_t v = t[w.x != 0 ? 0 : w.y != 0 ? 1 : 2];
    normal = vertexNormals_[v];
    isBeyond = isBorder_[v];
  } else if (zeros == 1) {
    const std::uint32_t side = 3 * hit.triangle + (w.z == 0 ? 0u : w.x == 0 ? 1u : 2u);
    const std::uint32_t other = opposite_[side];
    isBeyond = other == kNoHalfEdge;
    if (!isBeyond) normal = unit(normal + faceNormals_[other / 3]);
  }
  const glm::vec3 offset = query - hit.place.position;
  Place place{hit.place.position, std::sqrt(hit.squaredDistance), glm::dot(offset, normal), isBeyond,
              hit.triangle};
  if (!isBeyond) place.height = std::copysign(place.distance, place.height);
  return place;
}

}  // namespace sonoskin
