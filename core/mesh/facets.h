#pragma once

#include <algorithm>

#include "core/base/parallel_blocks.h"
#include "core/mesh/half_edges.h"

namespace sonoskin {

// Facets: the triangles of a mesh as a graph, for algorithms that walk from each to those beside it.
//   opposite  per half-edge, as oppositeHalfEdges gives it
//   normal    per triangle: the unit normal times the area in mm²; zero for a degenerate one
//   centre    per triangle: the mean of its corners
//   errors    Cancelled
struct Facets {
  const Mesh& mesh;
  std::vector<std::uint32_t> opposite;
  std::vector<glm::vec3> normal, centre;

  explicit Facets(const Mesh& surface, const Progress& progress = {});
  std::size_t size() const { return normal.size(); }
  float area(std::size_t t) const { return glm::length(normal[t]); }
  double area() const;
};

// As many triangles or vertices as a thread takes at a time where there is little to do for each.
inline constexpr std::size_t kFacetsPerTask = 1 << 14;

// Groups: items 0, 1, ... listed by the group that each belongs to, in their order.
struct Groups {
  std::vector<std::uint32_t> start, items;  // group g: items[start[g]] to items[start[g + 1] - 1]

  Groups(const std::vector<std::uint32_t>& groupOf, std::size_t groups);
  std::size_t size() const { return start.size() - 1; }
  const std::uint32_t* begin(std::size_t g) const { return items.data() + start[g]; }
  const std::uint32_t* end(std::size_t g) const { return items.data() + start[g + 1]; }
};

}  // namespace sonoskin
