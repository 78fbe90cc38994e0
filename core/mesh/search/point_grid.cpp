#include "core/mesh/search/point_grid.h"

namespace sonoskin {

PointGrid::PointGrid(const std::vector<glm::vec3>& positions, float cell) : box_(boundingBox(positions)) {
  constexpr float kMaxCells = 256;
  const glm::vec3 extent = box_.max - box_.min;
  cell_ = std::max(cell, std::max({extent.x, extent.y, extent.z}) / kMaxCells);
  inverseCell_ = 1 / cell_;
  dims_ = glm::ivec3(extent * inverseCell_) + 1;

  const auto cells = std::size_t(dims_.x) * std::size_t(dims_.y) * std::size_t(dims_.z);
  std::vector<std::uint32_t> cellOfPoint(positions.size());
  cellStart_.assign(cells + 1, 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::vec3& p = positions[i];
    cellOfPoint[i] = std::uint32_t((cellOf(p.z, 2) * dims_.y + cellOf(p.y, 1)) * dims_.x + cellOf(p.x, 0));
    ++cellStart_[cellOfPoint[i] + 1];
  }
  for (std::size_t c = 0; c < cells; ++c) cellStart_[c + 1] += cellStart_[c];
  std::vector<std::uint32_t> next(cellStart_.begin(), cellStart_.end() - 1);
  order_.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) order_[next[cellOfPoint[i]]++] = std::uint32_t(i);
}

namespace {

std::size_t occupiedBoxes(const std::vector<glm::vec3>& positions, const Box& box, double edge) {
  std::vector<std::uint64_t> boxes(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3 c = glm::floor(glm::dvec3(positions[i] - box.min) / edge);
    boxes[i] = (std::uint64_t(c.z) << 40) | (std::uint64_t(c.y) << 20) | std::uint64_t(c.x);
  }
  std::sort(boxes.begin(), boxes.end());
  return std::size_t(std::unique(boxes.begin(), boxes.end()) - boxes.begin());
}

}  // namespace

double pointSpacing(const std::vector<glm::vec3>& positions) {
  const Box box = boundingBox(positions);
  const double diagonal = double(box.diagonal());
  if (diagonal == 0) return 0;
  for (double edge = diagonal / 256;; edge *= 1.5) {
    const double perBox = double(positions.size()) / double(occupiedBoxes(positions, box, edge));
    if (perBox >= 1.5 || edge > diagonal) return edge / std::sqrt(perBox);
  }
}

}  // namespace sonoskin
