#include "core/mesh/atlas/atlas_nest.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sonoskin {
namespace {

int heightOf(const ChartOutline& outline) {
  return outline.high.empty() ? 0 : std::max(0, *std::ranges::max_element(outline.high));
}

// The lowest rows with a gutter to all sides, which is as wide: columns -gutter to width + gutter - 1.
std::vector<int> lowWithGutter(const ChartOutline& outline, int gutter) {
  constexpr int kNothing = 1 << 28;
  const int width = int(outline.low.size());
  std::vector<int> low(std::size_t(width + 2 * gutter), kNothing);
  for (int x = 0; x < width; ++x) {
    if (outline.low[std::size_t(x)] >= outline.high[std::size_t(x)]) continue;
    for (int c = x; c <= x + 2 * gutter; ++c)
      low[std::size_t(c)] = std::min(low[std::size_t(c)], outline.low[std::size_t(x)] - gutter);
  }
  return low;
}

// Skyline: how far up the columns of a picture are taken.
class Skyline {
 public:
  explicit Skyline(int width) : taken_(std::size_t(width), 0) {}

  // The row at which a chart comes to lie with its first column with gutter at x.
  int rowAt(int x, const std::vector<int>& low) const {
    const int* taken = taken_.data() + x;
    int row = 0;
    for (std::size_t c = 0; c < low.size(); ++c) row = std::max(row, taken[c] - low[c]);
    return row;
  }
  // place: where a chart comes to lie lowest.
  glm::ivec2 place(const ChartOutline& outline, int gutter) {
    const std::vector<int> low = lowWithGutter(outline, gutter);
    glm::ivec2 best(0, rowAt(0, low));
    for (int x = 1; x + int(low.size()) <= int(taken_.size()); ++x) {
      const int row = rowAt(x, low);
      if (row < best.y) best = {x, row};
    }
    best.x += gutter;
    for (std::size_t c = 0; c < outline.high.size(); ++c)
      if (outline.low[c] < outline.high[c]) taken_[std::size_t(best.x) + c] = best.y + outline.high[c];
    return best;
  }
  int height() const { return *std::ranges::max_element(taken_); }

 private:
  std::vector<int> taken_;
};

Packing packInto(int width, const std::vector<ChartOutline>& outlines, const std::vector<std::size_t>& order,
                 int gutter) {
  Skyline skyline(width);
  Packing packing{{width, 1}, std::vector<glm::ivec2>(outlines.size())};
  for (const std::size_t o : order) packing.place[o] = skyline.place(outlines[o], gutter);
  packing.size.y = skyline.height() + gutter;
  return packing;
}

std::vector<ChartOutline> outlinesOf(const Atlas& atlas, const std::vector<glm::ivec2>& placed) {
  std::vector<ChartOutline> outlines(placed.size());
  const auto include = [&](const Corners& corners, std::uint32_t chart) {
    const glm::vec2 origin(placed[chart]);
    const glm::ivec2 low(glm::floor(glm::min(glm::min(corners[0], corners[1]), corners[2]) - origin)),
        high(glm::floor(glm::max(glm::max(corners[0], corners[1]), corners[2]) - origin));
    ChartOutline& outline = outlines[chart];
    if (int(outline.low.size()) <= high.x) {
      outline.low.resize(std::size_t(high.x) + 1, 1 << 28);
      outline.high.resize(std::size_t(high.x) + 1, 0);
    }
    for (int x = std::max(low.x, 0); x <= high.x; ++x) {
      int &first = outline.low[std::size_t(x)], &end = outline.high[std::size_t(x)];
      first = std::min(first, low.y);
      end = std::max(end, high.y + 1);
    }
  };
  for (std::size_t t = 0; t < atlas.corners.size(); ++t) include(atlas.corners[t], atlas.chart[t]);
  for (std::size_t s = 0; s < atlas.skirts.size(); ++s) include(atlas.skirtCorners[s], atlas.skirtChart[s]);
  return outlines;
}

}  // namespace

Packing packOutlines(const std::vector<ChartOutline>& outlines, int gutter) {
  std::vector<std::size_t> order(outlines.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t o) { return heightOf(outlines[o]); });
  double area = 1;
  int widest = 1;
  for (const ChartOutline& o : outlines) {
    widest = std::max(widest, int(o.low.size()) + 2 * gutter);
    for (std::size_t x = 0; x < o.low.size(); ++x) area += std::max(o.high[x] - o.low[x], 0) + gutter;
  }
  Packing best;
  for (const double share : {1.0, 1.1, 1.2}) {
    Packing packing = packInto(std::max(widest, int(std::sqrt(area) * share)), outlines, order, gutter);
    const auto texels = [](const Packing& p) { return double(p.size.x) * double(p.size.y); };
    if (best.place.empty() || texels(packing) < texels(best)) best = std::move(packing);
  }
  return best;
}

void nestCharts(const std::vector<glm::ivec2>& placed, int gutter, Atlas& atlas) {
  constexpr std::size_t kMostCharts = 4000;  // of more each is so small that its box is as good
  if (placed.empty() || placed.size() > kMostCharts) return;
  const Packing packing = packOutlines(outlinesOf(atlas, placed), gutter);
  const auto texels = [](const glm::ivec2& size) { return double(size.x) * double(size.y); };
  if (texels(packing.size) >= texels(atlas.size) || packing.size.y > std::max(atlas.size.x, atlas.size.y) ||
      packing.size.x > std::max(atlas.size.x, atlas.size.y))
    return;
  const auto move = [&](Corners& corners, std::uint32_t chart) {
    for (glm::vec2& corner : corners) corner += glm::vec2(packing.place[chart] - placed[chart]);
  };
  for (std::size_t t = 0; t < atlas.corners.size(); ++t) move(atlas.corners[t], atlas.chart[t]);
  for (std::size_t s = 0; s < atlas.skirts.size(); ++s) move(atlas.skirtCorners[s], atlas.skirtChart[s]);
  atlas.size = packing.size;
}

}  // namespace sonoskin
