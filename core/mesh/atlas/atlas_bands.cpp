#include "core/mesh/atlas/atlas_bands.h"

#include <algorithm>
#include <numeric>

namespace sonoskin {

AtlasBands::AtlasBands(const glm::ivec2& size, const std::vector<Corners>& corners, float reach)
    : height_(size.y) {
  const int bands = std::max(1, (height_ + kRows - 1) / kRows);
  const auto bandAt = [&](float y) { return std::size_t(std::clamp(int(y) / kRows, 0, bands - 1)); };
  const auto forEachPlace = [&](const auto& f) {
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      const auto [low, high] = std::minmax({corners[i][0].y, corners[i][1].y, corners[i][2].y});
      for (std::size_t b = bandAt(low - reach); b <= bandAt(high + reach); ++b) f(b, i);
    }
  };
  start_.assign(std::size_t(bands) + 2, 0);
  forEachPlace([&](std::size_t b, std::uint32_t) { ++start_[b + 2]; });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  items_.resize(start_.back());
  forEachPlace([&](std::size_t b, std::uint32_t i) { items_[start_[b + 1]++] = i; });
  start_.pop_back();
}

}  // namespace sonoskin
