#include "core/mesh/atlas/atlas_nest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace sonoskin {
namespace {

// Every texel that a chart touches, and which one.
std::vector<int> picture(const std::vector<ChartOutline>& outlines, const Packing& packing) {
  std::vector<int> owner(std::size_t(packing.size.x) * std::size_t(packing.size.y), -1);
  for (std::size_t o = 0; o < outlines.size(); ++o)
    for (std::size_t c = 0; c < outlines[o].low.size(); ++c)
      for (int r = outlines[o].low[c]; r < outlines[o].high[c]; ++r) {
        const glm::ivec2 at = packing.place[o] + glm::ivec2(int(c), r);
        EXPECT_TRUE(at.x >= 0 && at.y >= 0 && at.x < packing.size.x && at.y < packing.size.y);
        owner[std::size_t(at.y * packing.size.x + at.x)] = int(o);
      }
  return owner;
}

void expectApart(const std::vector<ChartOutline>& outlines, const Packing& packing, int gutter) {
  const std::vector<int> owner = picture(outlines, packing);
  const auto at = [&](int x, int y) { return owner[std::size_t(y * packing.size.x + x)]; };
  for (int y = 0; y < packing.size.y; ++y)
    for (int x = 0; x < packing.size.x; ++x) {
      if (at(x, y) < 0) continue;
      EXPECT_TRUE(x >= gutter && y >= gutter && x < packing.size.x - gutter && y < packing.size.y - gutter);
      for (int v = std::max(0, y - gutter); v <= std::min(packing.size.y - 1, y + gutter); ++v)
        for (int u = std::max(0, x - gutter); u <= std::min(packing.size.x - 1, x + gutter); ++u)
          ASSERT_TRUE(at(u, v) < 0 || at(u, v) == at(x, y)) << x << ' ' << y;
    }
}

ChartOutline triangle(int side, bool turned) {
  ChartOutline outline;
  for (int x = 0; x < side; ++x) {
    outline.low.push_back(turned ? side - 1 - x : 0);
    outline.high.push_back(turned ? side : side - x);
  }
  return outline;
}

TEST(AtlasNest, ChartsOfAnyOutlineLieApart) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> width(1, 40), row(0, 30);
  std::vector<ChartOutline> outlines(60);
  for (ChartOutline& o : outlines)
    for (int x = width(random); x > 0; --x) {
      const auto [low, high] = std::minmax({row(random), row(random)});
      o.low.push_back(low);
      o.high.push_back(high);  // some columns are empty
    }
  expectApart(outlines, packOutlines(outlines, 3), 3);
}

TEST(AtlasNest, TrianglesLieInEachOthersBoxes) {
  std::vector<ChartOutline> outlines;
  double boxes = 0, area = 0;
  for (int i = 0; i < 40; ++i) {
    outlines.push_back(triangle(40, i % 2 == 1));
    boxes += 43 * 43;
    area += 40 * 41 / 2;
  }
  const Packing packing = packOutlines(outlines, 3);
  expectApart(outlines, packing, 3);
  const double texels = double(packing.size.x) * packing.size.y;
  EXPECT_GT(texels, area);
  EXPECT_LT(texels, 0.85 * boxes);
}

TEST(AtlasNest, OfNothingHasASize) {
  const Packing none = packOutlines({}, 3);
  EXPECT_GT(none.size.x, 0);
  EXPECT_GT(none.size.y, 0);
}

}  // namespace
}  // namespace sonoskin
