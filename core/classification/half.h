#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace sonoskin {

// Half: a number in [2^-14, 65504] with 11 significant bits: the bits of an IEEE half without sign, zero and
// denormals, so that both ways are three whole-number operations, which loops turn into vector code.
using Half = std::uint16_t;

inline constexpr float kLeastHalf = 0x1p-14f, kGreatestHalf = 65504;

// toHalf: the nearest Half; numbers beyond the range become its ends.
inline Half toHalf(float value) {
  constexpr std::uint32_t kRounding = 0x1000, kBias = 112u << 23;
  const float inside = std::min(std::max(value, kLeastHalf), kGreatestHalf);
  return Half((std::bit_cast<std::uint32_t>(inside) + kRounding - kBias) >> 13);
}

inline float toFloat(Half half) { return std::bit_cast<float>((std::uint32_t(half) << 13) + (112u << 23)); }

}  // namespace sonoskin
