#pragma once

#include <array>
#include <cstddef>

#include "core/rbf/compact/centre_index.h"

namespace sonoskin {

// SampleBlock: up to 64 places near each other at which the sums of S are gathered, centre by centre, in vector code.
//   x, y, z    mm, relative to an anchor that the block's user keeps
//   coverage   Σ φ_c
//   weighted   Σ φ_c (g_c + λ_c)
struct SampleBlock {
  static constexpr std::size_t kSize = 64;
  std::size_t count = 0;  // places in use, a multiple of 8
  alignas(32) std::array<float, kSize> x{}, y{}, z{}, coverage{}, weighted{};
};

// addCentre: adds one centre's share to the sums; `offset` is the anchor minus the centre's position, mm.
void addCentre(const Centre& centre, const glm::vec3& offset, SampleBlock& block);

// GradientBlock: the same for Σ [φ_c ∇g_c + (g_c + λ_c) ∇φ_c], which is Σφ times ∇S where S = 0.
struct GradientBlock {
  static constexpr std::size_t kSize = 64;
  std::size_t count = 0;  // places in use, a multiple of 8
  alignas(32) std::array<float, kSize> x{}, y{}, z{}, gx{}, gy{}, gz{};
};

void addCentre(const Centre& centre, const glm::vec3& offset, GradientBlock& block);

}  // namespace sonoskin
