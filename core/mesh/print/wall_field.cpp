#include "core/mesh/print/wall_field.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/half_edges.h"

namespace sonoskin {
namespace {

// Means over the 2 * reach + 1 neighbours along a closed loop, made unit.
std::vector<glm::vec3> smoothedLoop(const std::vector<glm::vec3>& values, std::size_t reach) {
  const std::size_t n = values.size();
  reach = std::min(reach, (n - 1) / 2);
  std::vector<glm::vec3> means(n);
  for (std::size_t i = 0; i < n; ++i) {
    glm::vec3 sum(0);
    for (std::size_t j = 0; j <= 2 * reach; ++j) sum += values[(i + n + j - reach) % n];
    const float length = glm::length(sum);
    means[i] = length > 0 ? sum / length : values[i];
  }
  return means;
}

}  // namespace

WallField::WallField(const Mesh& surface, float thickness, float cell)
    : thickness_(thickness), cell_(cell), surface_(surface) {
  makeRim(surface);
  if (!rim_.empty()) rimTree_.emplace(rim_);
}

void WallField::makeRim(const Mesh& surface) {
  const auto opposite = oppositeHalfEdges(surface.triangles, surface.positions.size());
  for (const auto& loop : borderLoops(surface.triangles, opposite)) {
    const auto first = std::uint32_t(rim_.positions.size()), n = std::uint32_t(loop.size());
    std::vector<glm::vec3> outward;
    float length = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      const Triangle& t = surface.triangles[loop[i] / 3];
      const glm::vec3 a = surface.positions[originOf(surface.triangles, loop[i])],
                      b = surface.positions[originOf(surface.triangles, nextHalfEdge(loop[i]))];
      const glm::vec3 normal = glm::cross(surface.positions[t[1]] - surface.positions[t[0]],
                                          surface.positions[t[2]] - surface.positions[t[0]]);
      const float size = glm::length(normal);
      outward.push_back(size > 0 ? glm::cross(b - a, normal / size) : glm::vec3(0));  // as long as the side
      length += glm::distance(a, b);
      rim_.positions.push_back(a);
      rim_.triangles.push_back({first + i, first + (i + 1) % n, first + (i + 1) % n});
    }
    // The wall's rim need not follow every tooth of the border.
    const auto reach = std::size_t(std::ceil(0.5f * thickness_ * float(n) / std::max(length, 1e-6f)));
    const std::vector<glm::vec3> smooth = smoothedLoop(outward, reach);
    rim_.normals.insert(rim_.normals.end(), smooth.begin(), smooth.end());
  }
}

// Where the rim is near: how far the query lies beyond it.
std::optional<float> WallField::beyondRim(const glm::vec3& query, const SignedDistance::Place& place) const {
  if (!rimTree_) return std::nullopt;
  const float reach = 1.5f * place.distance + cell_;  // farther away the rim is not what limits the wall
  const std::optional<TriangleTree::Hit> found = rimTree_->nearestWithin(query, reach);
  if (!found) return std::nullopt;
  const TriangleTree::Hit& hit = *found;
  const float distance = std::sqrt(hit.squaredDistance);
  const Triangle& side = rim_.triangles[hit.triangle];
  const glm::vec3& w = hit.place.weights;
  const glm::vec3 outward = w.x * rim_.normals[side[0]] + (w.y + w.z) * rim_.normals[side[1]];
  const float beyond = glm::dot(query - hit.place.position, outward);
  if (place.isBeyond) return beyond > -0.3f * place.distance ? beyond : 0.5f * cell_;
  // The border of another part of the surface passes by without a bite.
  const bool isNearest = distance <= 1.15f * place.distance + 0.5f * cell_;
  return isNearest ? beyond : std::min(beyond, -0.5f * cell_);
}

WallField::Value WallField::at(const glm::vec3& query, std::uint32_t guess) const {
  const SignedDistance::Place place = surface_.at(query, guess);
  float field = std::max(place.height, -place.height - thickness_);
  if (field < 4 * cell_)
    if (const auto beyond = beyondRim(query, place)) field = std::max(field, *beyond);
  return {field, place.distance, place.triangle};
}

}  // namespace sonoskin
