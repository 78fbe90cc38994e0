#pragma once

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace sonoskin {

namespace lane_packer {

// For every set of lanes: the numbers of its lanes in ascending order, a byte each.
constexpr std::array<std::uint64_t, 256> makeOrders() {
  std::array<std::uint64_t, 256> orders{};
  for (unsigned set = 0; set < 256; ++set)
    for (unsigned lane = 8; lane-- > 0;)
      if (set >> lane & 1) orders[set] = orders[set] << 8 | lane;
  return orders;
}
inline constexpr std::array<std::uint64_t, 256> kOrders = makeOrders();

}  // namespace lane_packer

// LanePacker: moves those of eight numbers that were chosen to the front; for filters over long arrays, which the
// compiler leaves scalar.
class LanePacker {
 public:
  static constexpr std::size_t kLanes = 8;

  // chosen   one bit per lane
  explicit LanePacker(unsigned chosen)
      : order_(_mm256_cvtepu8_epi32(_mm_cvtsi64_si128(std::int64_t(lane_packer::kOrders[chosen])))),
        count_(std::size_t(std::popcount(chosen))) {}

  std::size_t count() const { return count_; }
  // pack: writes all eight numbers, the chosen ones first.
  void pack(__m256 from, float* to) const { _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(from, order_)); }
  void pack(__m256i from, std::uint32_t* to) const {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(from, order_));
  }

  // firstLanes: a mask of the first `count` lanes for _mm256_maskload_ps.
  static __m256i firstLanes(std::size_t count) {
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    return _mm256_cmpgt_epi32(_mm256_set1_epi32(int(count < kLanes ? count : kLanes)), lane);
  }

 private:
  __m256i order_;
  std::size_t count_;
};

}  // namespace sonoskin
