#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/skin/gaussian_sum.h"

namespace sonoskin {

// RadialProfile: R(r) of three colours as a table over r^2, fine near 0 and coarse far away: 64 steps of equal length for
// every doubling of r^2. Between them it is linear, wrong by 2e-5 of the largest value at most. 35 KB.
class RadialProfile {
 public:
  // perArea   1/mm^2 at r mm
  // total     its integral over the plane
  RadialProfile(const std::function<glm::dvec3(double r)>& perArea, const glm::dvec3& total);

  glm::vec3 operator()(float squaredDistance) const {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(std::min(squaredDistance, kMost) + kLeast);
    const std::uint32_t step = (bits >> kShift) - kFirstStep;
    const float part = float(bits & ((1u << kShift) - 1)) * (1.f / float(1u << kShift));
    return glm::vec3(table_[step] + part * (table_[step + 1] - table_[step]));
  }
  const glm::dvec3& total() const { return total_; }

 private:
  static constexpr std::uint32_t kShift = 17;  // a float without its 17 last bits: 64 steps an octave
  static constexpr float kLeast = 0x1p-13f, kMost = 0x1p20f;  // mm^2
  static constexpr std::uint32_t kFirstStep = (127u - 13u) << (23 - kShift);

  std::vector<glm::vec4> table_;
  glm::dvec3 total_;
};

// profileOf: the Gaussians from number `first` on.
RadialProfile profileOf(const GaussianSum& sum, int first = 0);

}  // namespace sonoskin
