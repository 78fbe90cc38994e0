#include "core/mesh/atlas/atlas_pack.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sonoskin {
namespace {

Packing packShelves(const std::vector<glm::ivec2>& boxes, const std::vector<std::size_t>& order, int gutter,
                    int width) {
  Packing packing{glm::ivec2(gutter), std::vector<glm::ivec2>(boxes.size())};
  glm::ivec2 next(gutter);
  int shelf = 0;
  for (const std::size_t b : order) {
    if (next.x > gutter && next.x + boxes[b].x + gutter > width) {
      next = {gutter, next.y + shelf + gutter};
      shelf = 0;
    }
    packing.place[b] = next;
    next.x += boxes[b].x + gutter;
    shelf = std::max(shelf, boxes[b].y);
    packing.size = glm::max(packing.size, glm::ivec2(next.x, next.y + shelf + gutter));
  }
  return packing;
}

}  // namespace

Packing packBoxes(const std::vector<glm::ivec2>& boxes, int gutter) {
  constexpr int kWidths = 24;
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return boxes[a].y != boxes[b].y ? boxes[a].y > boxes[b].y : a < b;
  });
  double area = 1;
  for (const glm::ivec2& b : boxes) area += double(b.x + gutter) * double(b.y + gutter);
  Packing best;
  double least = 0;
  for (int i = 0; i < kWidths; ++i) {
    const int width = int(std::sqrt(area) * (0.9 + 0.04 * i));
    Packing packing = packShelves(boxes, order, gutter, width);
    const double x = packing.size.x, y = packing.size.y, cost = x * y * (1 + 0.1 * std::abs(std::log(x / y)));
    if (i > 0 && cost >= least) continue;
    least = cost;
    best = std::move(packing);
  }
  return best;
}

}  // namespace sonoskin
