#include "core/skin/radial_profile.h"

#include <cmath>

namespace sonoskin {

RadialProfile::RadialProfile(const std::function<glm::dvec3(double r)>& perArea, const glm::dvec3& total)
    : total_(total) {
  const std::uint32_t lastStep = std::bit_cast<std::uint32_t>(kMost + kLeast) >> kShift;
  for (std::uint32_t step = kFirstStep; step <= lastStep + 1; ++step) {
    const double squared = double(std::bit_cast<float>(step << kShift)) - double(kLeast);
    table_.emplace_back(glm::vec3(perArea(std::sqrt(squared))), 0.f);
  }
}

RadialProfile profileOf(const GaussianSum& sum, int first) {
  GaussianSum kept = sum;
  glm::dvec3 total(0);
  for (std::size_t i = 0; i < GaussianSum::kCount; ++i) {
    if (int(i) < first) kept.weights[i] = glm::dvec3(0);
    total += kept.weights[i];
  }
  return RadialProfile([kept](double r) { return profileAt(kept, r); }, total);
}

}  // namespace sonoskin
