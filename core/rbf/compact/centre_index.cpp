#include "core/rbf/compact/centre_index.h"

#include <algorithm>

namespace sonoskin {

CentreIndex::CentreIndex(std::vector<Centre> centres, float cell, float pad)
    : centres_(std::move(centres)), cell_(cell) {
  if (centres_.empty()) return;
  box_ = {centres_[0].position, centres_[0].position};
  for (const Centre& c : centres_) {
    box_.min = glm::min(box_.min, c.position - c.support - pad);
    box_.max = glm::max(box_.max, c.position + c.support + pad);
  }
  dims_ = glm::ivec3((box_.max - box_.min) / cell_) + 1;
  start_.assign(std::size_t(dims_.x) * std::size_t(dims_.y) * std::size_t(dims_.z) + 1, 0);
  for (const Centre& c : centres_) forEachCell(c, pad, [&](std::size_t i) { ++start_[i + 1]; });
  for (std::size_t i = 0; i + 1 < start_.size(); ++i) start_[i + 1] += start_[i];
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  list_.resize(start_.back());
  for (std::uint32_t n = 0; n < centres_.size(); ++n)
    forEachCell(centres_[n], pad, [&](std::size_t i) { list_[next[i]++] = n; });
}

// Calls f(cell) for the cells that come within support + pad of the centre.
template <class F>
void CentreIndex::forEachCell(const Centre& centre, float pad, F&& f) const {
  const float reach = centre.support + pad;
  const glm::vec3 p = centre.position - box_.min;
  const glm::ivec3 low = glm::clamp(glm::ivec3(glm::floor((p - reach) / cell_)), glm::ivec3(0), dims_ - 1);
  const glm::ivec3 high = glm::clamp(glm::ivec3(glm::floor((p + reach) / cell_)), glm::ivec3(0), dims_ - 1);
  for (int k = low.z; k <= high.z; ++k)
    for (int j = low.y; j <= high.y; ++j)
      for (int i = low.x; i <= high.x; ++i) {
        const glm::vec3 corner = glm::vec3(i, j, k) * cell_;
        const glm::vec3 gap = p - glm::clamp(p, corner, corner + cell_);
        if (glm::dot(gap, gap) > reach * reach * 1.0001f) continue;
        f((std::size_t(k) * std::size_t(dims_.y) + std::size_t(j)) * std::size_t(dims_.x) + std::size_t(i));
      }
}

std::span<const std::uint32_t> CentreIndex::near(const glm::vec3& x) const {
  const glm::vec3 cell = glm::floor((x - box_.min) / cell_);
  for (int axis = 0; axis < 3; ++axis)
    if (!(cell[axis] >= 0 && cell[axis] < float(dims_[axis]))) return {};
  const std::size_t i =
      (std::size_t(cell.z) * std::size_t(dims_.y) + std::size_t(cell.y)) * std::size_t(dims_.x) +
      std::size_t(cell.x);
  return {list_.data() + start_[i], list_.data() + start_[i + 1]};
}

}  // namespace sonoskin
