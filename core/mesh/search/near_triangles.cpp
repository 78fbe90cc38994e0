#include "core/mesh/search/near_triangles.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

float longest(const glm::vec3& v) { return std::max({v.x, v.y, v.z}); }

// CellMarks: marks on cubic cells of space.
class CellMarks {
 public:
  CellMarks(const Box& box, float cell) : low_(box.min) {
    constexpr float kMostCells = 160;  // along an axis
    cell_ = std::max({cell, longest(box.max - box.min) / kMostCells, 1e-6f});
    const glm::vec3 extent = box.max - box.min;
    dims_ = glm::ivec3(extent / cell_) + 1;
    marks_.assign(std::size_t(dims_.x) * std::size_t(dims_.y) * std::size_t(dims_.z), 0);
  }
  // forEach: calls f(mark) for the cells that a triangle's box meets.
  template <class F>
  void forEach(const Mesh& mesh, const Triangle& t, const F& f) {
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const glm::ivec3 low = at(glm::min(a, glm::min(b, c))), high = at(glm::max(a, glm::max(b, c)));
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) f(marks_[index({x, y, z})]);
  }
  // grow: marks with 2 what lies within `reach` of a cell that is marked with 1.
  void grow(float reach) {
    const int steps = int(std::ceil(reach / cell_));
    for (int z = 0; z < dims_.z; ++z)
      for (int y = 0; y < dims_.y; ++y)
        for (int x = 0; x < dims_.x; ++x)
          if (marks_[index({x, y, z})] == 1) growFrom({x, y, z}, steps, reach);
  }

 private:
  glm::ivec3 at(const glm::vec3& p) const {
    return glm::clamp(glm::ivec3((p - low_) / cell_), glm::ivec3(0), dims_ - 1);
  }
  std::size_t index(const glm::ivec3& c) const {
    return (std::size_t(c.z) * std::size_t(dims_.y) + std::size_t(c.y)) * std::size_t(dims_.x) +
           std::size_t(c.x);
  }
  void growFrom(const glm::ivec3& from, int steps, float reach) {
    const glm::ivec3 low = glm::max(from - steps, glm::ivec3(0)), high = glm::min(from + steps, dims_ - 1);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y) {
        // What is left between the nearest sides of two cells.
        const glm::vec2 gap = cell_ * glm::max(glm::abs(glm::vec2(y - from.y, z - from.z)) - 1.f, 0.f);
        const float rest = reach * reach - glm::dot(gap, gap);
        if (rest < 0) continue;
        const int along = int(std::sqrt(rest) / cell_) + 1;
        for (int x = std::max(from.x - along, low.x); x <= std::min(from.x + along, high.x); ++x) {
          std::uint8_t& mark = marks_[index({x, y, z})];
          if (mark == 0) mark = 2;
        }
      }
  }

  glm::vec3 low_;
  float cell_;
  glm::ivec3 dims_;
  std::vector<std::uint8_t> marks_;
};

float longestSide(const Mesh& mesh) {
  float side = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
    side = std::max(side, longest(glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c))));
  }
  return side;
}

template <class T>
void keep(const std::vector<T>& values, const std::vector<std::uint32_t>& kept, std::vector<T>& to) {
  if (values.empty()) return;
  to.reserve(kept.size());
  for (const std::uint32_t i : kept) to.push_back(values[i]);
}

}  // namespace

std::vector<std::uint8_t> trianglesWithin(const Mesh& mesh, const std::vector<std::uint8_t>& isMarked,
                                          float reach) {
  // No triangle meets more than some cells.
  CellMarks cells(boundingBox(mesh.positions), std::max(reach, longestSide(mesh)) / 4);
  for (std::size_t t = 0; t < isMarked.size(); ++t)
    if (isMarked[t]) cells.forEach(mesh, mesh.triangles[t], [](std::uint8_t& mark) { mark = 1; });
  cells.grow(reach);
  std::vector<std::uint8_t> within(isMarked.size(), 0);
  for (std::size_t t = 0; t < within.size(); ++t)
    cells.forEach(mesh, mesh.triangles[t], [&](std::uint8_t mark) { within[t] |= mark > 0; });
  return within;
}

Mesh selectTriangles(const Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
  Mesh part;
  std::vector<std::uint32_t> vertices, number(mesh.positions.size(), kNone);
  keep(mesh.triangles, triangles, part.triangles);
  keep(mesh.cornerUvs, triangles, part.cornerUvs);
  for (Triangle& t : part.triangles)
    for (std::uint32_t& v : t) {
      if (number[v] == kNone) {
        number[v] = std::uint32_t(vertices.size());
        vertices.push_back(v);
      }
      v = number[v];
    }
  keep(mesh.positions, vertices, part.positions);
  keep(mesh.normals, vertices, part.normals);
  keep(mesh.visibility, vertices, part.visibility);
  keep(mesh.measured, vertices, part.measured);
  keep(mesh.labels, vertices, part.labels);
  return part;
}

}  // namespace sonoskin
