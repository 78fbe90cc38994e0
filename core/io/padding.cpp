#include "core/io/padding.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sonoskin {
namespace {

constexpr double kMostSides = 0.5;     // share of the sides' finite voxels that padding has at least
constexpr double kLeastSides = 0.1;    // share of the sides that must be finite to say anything
constexpr float kNearlyAlike = 0.02f;  // of the range of all
constexpr std::size_t kSamples = 400'000;

std::vector<float> finiteOnes(std::vector<float> values) {
  std::erase_if(values, [](float v) { return !std::isfinite(v); });
  return values;
}

// Whole numbers of a narrow range, which files of 8 and 16 bits have, are counted instead of compared.
void sortValues(std::vector<float>& values) {
  constexpr float kWidest = 1 << 16;
  if (values.empty()) return;
  const auto [least, most] = std::ranges::minmax(values);
  const bool whole = most - least < kWidest && std::abs(least) < kWidest &&
                     std::ranges::all_of(values, [](float v) { return v == std::floor(v); });
  if (!whole) {
    std::ranges::sort(values);
    return;
  }
  std::vector<std::size_t> counts(std::size_t(most - least) + 1);
  for (const float v : values) ++counts[std::size_t(v - least)];
  auto at = values.begin();
  for (std::size_t c = 0; c < counts.size(); ++c) at = std::fill_n(at, counts[c], least + float(c));
}

// The finite ones, sorted; `count` is that of all.
std::vector<float> valuesOnSides(const Volume<float>& volume, std::size_t& count) {
  const glm::ivec3 d = volume.geometry.dims;
  std::vector<float> values;
  for (int k = 0; k < d.z; ++k)
    for (int j = 0; j < d.y; ++j)
      for (int i = 0; i < d.x;
           i += j == 0 || k == 0 || j == d.y - 1 || k == d.z - 1 ? 1 : std::max(1, d.x - 1))
        values.push_back(volume.at(i, j, k));
  count = values.size();
  values = finiteOnes(std::move(values));
  sortValues(values);
  return values;
}

std::vector<float> sampleOf(const Volume<float>& volume) {
  const std::size_t stride = (volume.data.size() / kSamples) | 1;
  std::vector<float> values;
  for (std::size_t v = 0; v < volume.data.size(); v += stride) values.push_back(volume.data[v]);
  return finiteOnes(std::move(values));
}

// The range of all but a thousandth at each end.
float rangeOf(std::vector<float>& values) {
  const auto nth = [&](std::size_t n) {
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(n), values.end());
    return values[n];
  };
  return nth(values.size() * 999 / 1000) - nth(values.size() / 1000);
}

// The window of a width that holds most of sorted values, as the padding that it would be, and how many it holds.
std::pair<Padding, std::size_t> fullestWindow(const std::vector<float>& sorted, float width) {
  std::pair<Padding, std::size_t> best{{}, 0};
  for (std::size_t first = 0, last = 0; first < sorted.size(); ++first) {
    while (last < sorted.size() && sorted[last] <= sorted[first] + width) ++last;
    if (last - first > best.second) best = {{sorted[first], sorted[last - 1]}, last - first};
  }
  return best;
}

}  // namespace

std::optional<Padding> findPadding(const Volume<float>& volume) {
  std::size_t onSides = 0;
  const std::vector<float> sides = valuesOnSides(volume, onSides);
  std::vector<float> all = sampleOf(volume);
  if (all.empty() || std::ranges::min(all) == std::ranges::max(all) ||
      double(sides.size()) <= kLeastSides * double(onSides))
    return {};
  const auto isMost = [&](std::size_t count) { return double(count) > kMostSides * double(sides.size()); };
  const auto [exact, alike] = fullestWindow(sides, 0);
  if (isMost(alike)) return exact;
  const auto [near, count] = fullestWindow(sides, kNearlyAlike * rangeOf(all));
  return isMost(count) ? std::optional(near) : std::nullopt;
}

}  // namespace sonoskin
