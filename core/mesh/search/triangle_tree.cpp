#include "core/mesh/search/triangle_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "core/base/error.h"

namespace sonoskin {
namespace {

// Spreads the low 10 bits of a number three places apart.
std::uint32_t spreadBits(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000ffu;
  x = (x | (x << 8)) & 0x0300f00fu;
  x = (x | (x << 4)) & 0x030c30c3u;
  return (x | (x << 2)) & 0x09249249u;
}

// Place on the Morton curve through a box of 1024³ cells.
std::uint32_t mortonCode(const glm::vec3& inUnitBox) {
  const glm::uvec3 c(glm::clamp(inUnitBox * 1024.f, 0.f, 1023.f));
  return spreadBits(c.x) | (spreadBits(c.y) << 1) | (spreadBits(c.z) << 2);
}

Box emptyBox() {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return {glm::vec3(kInfinity), glm::vec3(-kInfinity)};
}

Box unite(const Box& a, const Box& b) { return {glm::min(a.min, b.min), glm::max(a.max, b.max)}; }

float squaredDistance(const Box& box, const glm::vec3& p) {
  const glm::vec3 d = glm::max(glm::max(box.min - p, p - box.max), glm::vec3(0));
  return glm::dot(d, d);  // infinite for an empty box
}

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh) : mesh_(mesh) {
  require(!mesh.empty(), "The mesh has no triangles.");
  const Box box = boundingBox(mesh.positions);
  const glm::vec3 scale = 1.f / glm::max(box.max - box.min, glm::vec3(1e-20f));
  std::vector<std::uint64_t> keys(mesh.triangles.size());
  for (std::size_t t = 0; t < keys.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const glm::vec3 middle = (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3.f;
    keys[t] = (std::uint64_t(mortonCode((middle - box.min) * scale)) << 32) | t;
  }
  std::sort(keys.begin(), keys.end());
  for (const std::uint64_t key : keys) order_.push_back(std::uint32_t(key));

  leaves_ = std::bit_ceil((order_.size() + kLeaf - 1) / kLeaf);
  boxes_.assign(2 * leaves_, emptyBox());
  for (std::size_t i = 0; i < order_.size(); ++i) {
    Box& leaf = boxes_[leaves_ + i / kLeaf];
    leaf = unite(leaf, boxOf(i));
  }
  for (std::size_t n = leaves_ - 1; n > 0; --n) boxes_[n] = unite(boxes_[2 * n], boxes_[2 * n + 1]);
}

Box TriangleTree::boxOf(std::size_t place) const {
  const auto& [a, b, c] = mesh_.triangles[order_[place]];
  const Box first{mesh_.positions[a], mesh_.positions[a]}, second{mesh_.positions[b], mesh_.positions[b]};
  return unite(unite(first, second), {mesh_.positions[c], mesh_.positions[c]});
}

void TriangleTree::tryTriangle(const glm::vec3& query, std::uint32_t triangle, Hit& best) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  const ClosestPoint place =
      closestPointOnTriangle(query, mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]);
  const glm::vec3 d = place.position - query;
  if (const float squared = glm::dot(d, d); squared < best.squaredDistance) best = {triangle, place, squared};
}

void TriangleTree::searchLeaf(const glm::vec3& query, std::size_t leaf, Hit& best) const {
  const std::size_t last = std::min((leaf + 1) * kLeaf, order_.size());
  for (std::size_t i = leaf * kLeaf; i < last; ++i) tryTriangle(query, order_[i], best);
}

TriangleTree::Hit TriangleTree::nearest(const glm::vec3& query, std::uint32_t guess) const {
  Hit best;
  best.squaredDistance = std::numeric_limits<float>::infinity();
  if (guess < mesh_.triangles.size()) tryTriangle(query, guess, best);
  search(query, best);
  return best;
}

std::optional<TriangleTree::Hit> TriangleTree::nearestWithin(const glm::vec3& query, float limit) const {
  Hit best;
  best.squaredDistance = limit * limit;
  search(query, best);
  if (best.squaredDistance < limit * limit) return best;
  return std::nullopt;
}

// Replaces `best` by what is nearer.
void TriangleTree::search(const glm::vec3& query, Hit& best) const {
  struct Pending {
    std::size_t node;
    float squaredDistance;
  };
  std::array<Pending, 64> stack;  // one per level is enough
  std::size_t depth = 0;
  stack[depth++] = {1, squaredDistance(boxes_[1], query)};
  while (depth > 0) {
    const Pending next = stack[--depth];
    if (next.squaredDistance >= best.squaredDistance) continue;
    if (next.node >= leaves_) {
      searchLeaf(query, next.node - leaves_, best);
      continue;
    }
    Pending near{2 * next.node, squaredDistance(boxes_[2 * next.node], query)};
    Pending far{2 * next.node + 1, squaredDistance(boxes_[2 * next.node + 1], query)};
    if (far.squaredDistance < near.squaredDistance) std::swap(near, far);
    stack[depth++] = far;  // the nearer one is searched first and shrinks what remains of the farther
    stack[depth++] = near;
  }
}

}  // namespace sonoskin
