#include "core/mesh/atlas/atlas_pack.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

TEST(AtlasPack, BoxesKeepAwayFromEachOtherAndFromTheSides) {
  std::vector<glm::ivec2> boxes{{0, 0}, {200, 3}, {3, 120}};
  std::uint32_t state = 1;
  for (int i = 0; i < 60; ++i) {
    state = 1664525 * state + 1013904223;
    boxes.emplace_back(1 + state % 97, 1 + (state >> 8) % 61);
  }
  const Packing packing = packBoxes(boxes, 3);
  double area = 0;
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    const glm::ivec2 low = packing.place[a], high = low + boxes[a];
    area += (boxes[a].x + 3.) * (boxes[a].y + 3.);
    EXPECT_TRUE(low.x >= 3 && low.y >= 3);
    EXPECT_TRUE(high.x + 3 <= packing.size.x && high.y + 3 <= packing.size.y);
    for (std::size_t b = 0; b < a; ++b) {
      const glm::ivec2 from = packing.place[b], to = from + boxes[b];
      EXPECT_TRUE(low.x >= to.x + 3 || from.x >= high.x + 3 || low.y >= to.y + 3 || from.y >= high.y + 3);
    }
  }
  EXPECT_LT(double(packing.size.x) * packing.size.y, 1.6 * area);
}

TEST(AtlasPack, NothingFitsAnywhere) {
  EXPECT_GT(packBoxes({}, 3).size.x, 0);
  const Packing one = packBoxes({{10, 20}}, 3);
  EXPECT_EQ(one.size, glm::ivec2(16, 26));
}

}  // namespace
}  // namespace sonoskin
