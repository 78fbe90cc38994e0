#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// PointGrid: points sorted into cubic cells, so that a radius query is a few contiguous runs of sorted
// points.
//   cost   O(N + cells) to build; a query touches the cells it overlaps and nothing else
class PointGrid {
 public:
  PointGrid() = default;
  // cell   edge in mm, > 0; enlarged where the box would need more than 256 cells along an axis
  PointGrid(const std::vector<glm::vec3>& positions, float cell);

  // order()[s] is the index among the positions of the s-th sorted point.
  const std::vector<std::uint32_t>& order() const { return order_; }
  const Box& box() const { return box_; }

  // forEachRun: calls f(first, last) for runs [first, last) of sorted points that hold every point closer
  // than `radius` to `centre`, and some that are farther.
  template <class F>
  void forEachRun(const glm::vec3& centre, float radius, F&& f) const;

 private:
  static constexpr float kSlack = 1.0001f;  // covers the rounding of float coordinates

  int cellOf(float coordinate, int axis) const {
    return std::clamp(int((coordinate - box_.min[axis]) * inverseCell_), 0, dims_[axis] - 1);
  }
  // Distance along one axis from a coordinate to the slab of cells with number c.
  float gap(float coordinate, int c, int axis) const {
    const float low = box_.min[axis] + float(c) * cell_;
    return std::max(0.f, std::max(low - coordinate, coordinate - (low + cell_)));
  }

  Box box_;
  float cell_ = 1, inverseCell_ = 1;
  glm::ivec3 dims_{0};
  std::vector<std::uint32_t> cellStart_, order_;
};

template <class F>
void PointGrid::forEachRun(const glm::vec3& centre, float radius, F&& f) const {
  const float r = radius * kSlack;
  const glm::ivec3 low(cellOf(centre.x - r, 0), cellOf(centre.y - r, 1), cellOf(centre.z - r, 2));
  const glm::ivec3 high(cellOf(centre.x + r, 0), cellOf(centre.y + r, 1), cellOf(centre.z + r, 2));
  for (int k = low.z; k <= high.z; ++k) {
    const float gapZ = gap(centre.z, k, 2);
    for (int j = low.y; j <= high.y; ++j) {
      const float gapY = gap(centre.y, j, 1);
      const float rest = r * r - gapZ * gapZ - gapY * gapY;
      if (rest < 0) continue;
      const float reach = std::sqrt(rest) + (kSlack - 1) * cell_;
      const auto row = std::size_t(k * dims_.y + j) * std::size_t(dims_.x);
      const std::uint32_t first = cellStart_[row + std::size_t(cellOf(centre.x - reach, 0))];
      const std::uint32_t last = cellStart_[row + std::size_t(cellOf(centre.x + reach, 0)) + 1];
      if (first < last) f(std::size_t(first), std::size_t(last));
    }
  }
}

// pointSpacing: h = 1/sqrt(density) of points on a surface, mm; 0 if all are at one place.
//   method   points per occupied box of edge c: h = c / sqrt(N / boxes); c = diagonal/256, enlarged until there
//            are 1.5 points in a box
double pointSpacing(const std::vector<glm::vec3>& positions);

}  // namespace sonoskin
