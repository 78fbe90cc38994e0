#include "core/rbf/lane_packer.h"

#include <gtest/gtest.h>

#include <vector>

namespace sonoskin {
namespace {

TEST(LanePacker, KeepsTheChosenLanesInOrder) {
  const __m256 values = _mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7);
  const __m256i numbers = _mm256_setr_epi32(10, 11, 12, 13, 14, 15, 16, 17);
  for (unsigned chosen = 0; chosen < 256; ++chosen) {
    std::vector<unsigned> expected;
    for (unsigned lane = 0; lane < 8; ++lane)
      if (chosen >> lane & 1) expected.push_back(lane);
    float packed[8];
    std::uint32_t packedNumbers[8];
    const LanePacker packer(chosen);
    packer.pack(values, packed);
    packer.pack(numbers, packedNumbers);
    ASSERT_EQ(packer.count(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(packed[i], float(expected[i]));
      EXPECT_EQ(packedNumbers[i], expected[i] + 10);
    }
  }
}

TEST(LanePacker, MasksTheFirstLanes) {
  const float values[8] = {1, 1, 1, 1, 1, 1, 1, 1};
  for (std::size_t count = 0; count < 20; ++count) {
    float loaded[8];
    _mm256_storeu_ps(loaded, _mm256_maskload_ps(values, LanePacker::firstLanes(count)));
    for (std::size_t lane = 0; lane < 8; ++lane) EXPECT_EQ(loaded[lane], lane < count ? 1.f : 0.f);
  }
}

}  // namespace
}  // namespace sonoskin
