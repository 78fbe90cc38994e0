#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <vector>

#include "core/mesh/closest_point.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// TriangleTree: finds the place of a mesh nearest to a point, and the triangles in a box. Keeps a reference to the mesh.
//   method   triangles sorted along a space-filling curve, four to a leaf, boxes in an implicit binary tree
//   cost     500k triangles: built in 0.1 s; a query takes 1 to 2 us near the surface
//   errors   Error: the mesh has no triangles
class TriangleTree {
 public:
  explicit TriangleTree(const Mesh& mesh);

  struct Hit {
    std::uint32_t triangle = 0;
    ClosestPoint place;
    float squaredDistance = 0;
  };
  // nearest: the closest place of the mesh.
  //   guess   a triangle that may be near (the last hit for a neighbouring query); it saves time only
  Hit nearest(const glm::vec3& query, std::uint32_t guess = 0) const;

  // nearestWithin: the closest place, if it is nearer than `limit`; farther ones cost nothing.
  std::optional<Hit> nearestWithin(const glm::vec3& query, float limit) const;

  // forEachNear: calls f(triangle) for every triangle that may meet the box; misses none.
  template <class F>
  void forEachNear(const Box& box, F&& f) const;

  // leaves: of a few triangles each; forEachPair: calls f(a, b) for every two triangles whose boxes meet, of which one lies in
  // the leaf and the other in it or in a later one: over all leaves, once for every pair.
  std::size_t leaves() const { return (order_.size() + kLeaf - 1) / kLeaf; }
  template <class F>
  void forEachPair(std::size_t leaf, F&& f) const;

 private:
  static constexpr std::size_t kLeaf = 4;

  Box boxOf(std::size_t place) const;  // of a triangle, by its place along the curve
  std::size_t lastLeaf(std::size_t node) const {
    const auto below = std::bit_width(leaves_) - std::bit_width(node);
    return ((node + 1) << below) - 1 - leaves_;
  }
  template <class F>
  void pairWith(std::size_t leaf, std::size_t later, const std::array<Box, kLeaf>& boxes, F&& f) const;

  void tryTriangle(const glm::vec3& query, std::uint32_t triangle, Hit& best) const;
  void searchLeaf(const glm::vec3& query, std::size_t leaf, Hit& best) const;
  void search(const glm::vec3& query, Hit& best) const;

  const Mesh& mesh_;
  std::vector<std::uint32_t> order_;  // triangles along the curve
  std::size_t leaves_ = 1;            // a power of two
  std::vector<Box> boxes_;            // node n has children 2n and 2n+1; leaf l is node leaves_ + l
};

template <class F>
void TriangleTree::forEachNear(const Box& box, F&& f) const {
  std::array<std::size_t, 64> stack;  // one per level is enough
  std::size_t depth = 0;
  stack[depth++] = 1;
  while (depth > 0) {
    const std::size_t node = stack[--depth];
    if (!overlap(boxes_[node], box)) continue;
    if (node < leaves_) {
      stack[depth++] = 2 * node + 1;
      stack[depth++] = 2 * node;
      continue;
    }
    const std::size_t first = (node - leaves_) * kLeaf, last = std::min(first + kLeaf, order_.size());
    for (std::size_t i = first; i < last; ++i) f(order_[i]);
  }
}

template <class F>
void TriangleTree::pairWith(std::size_t leaf, std::size_t later, const std::array<Box, kLeaf>& boxes,
                            F&& f) const {
  const std::size_t end = std::min((leaf + 1) * kLeaf, order_.size()),
                    laterEnd = std::min((later + 1) * kLeaf, order_.size());
  for (std::size_t j = later * kLeaf; j < laterEnd; ++j) {
    const Box box = boxOf(j);
    for (std::size_t i = leaf * kLeaf; i < std::min(end, j); ++i)
      if (overlap(boxes[i % kLeaf], box)) f(order_[i], order_[j]);
  }
}

template <class F>
void TriangleTree::forEachPair(std::size_t leaf, F&& f) const {
  std::array<Box, kLeaf> boxes;
  for (std::size_t i = leaf * kLeaf; i < std::min((leaf + 1) * kLeaf, order_.size()); ++i)
    boxes[i % kLeaf] = boxOf(i);
  std::array<std::size_t, 64> stack;  // one per level is enough
  std::size_t depth = 0;
  stack[depth++] = 1;
  while (depth > 0) {
    const std::size_t node = stack[--depth];
    if (lastLeaf(node) < leaf || !overlap(boxes_[node], boxes_[leaves_ + leaf])) continue;
    if (node >= leaves_) {
      pairWith(leaf, node - leaves_, boxes, f);
    } else {
      stack[depth++] = 2 * node + 1;
      stack[depth++] = 2 * node;
    }
  }
}

}  // namespace sonoskin
