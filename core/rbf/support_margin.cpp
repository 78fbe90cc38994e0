#include "core/rbf/support_margin.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {

SupportMargin::SupportMargin(const std::vector<glm::vec3>& points, float spacing, float gap, float coverage)
    : spacing_(spacing), gap_(gap), coverage_(coverage), grid_(points, 2.2f * spacing) {
  sorted_.reserve(points.size());
  for (const std::uint32_t i : grid_.order()) sorted_.push_back(points[i]);
}

float SupportMargin::at(const glm::vec3& place, float coverage, Hint& hint) const {
  const float covered = coverage_ > 0 ? std::clamp((coverage - coverage_) / coverage_, -kBand, kBand) : kBand;
  if (covered <= -kBand) return covered;
  const float safe = (1 - kBand) * gap_;
  for (std::size_t i = 0; i < hint.count; ++i) {
    const glm::vec3 d = hint.points[i] - place;
    if (glm::dot(d, d) < safe * safe) return covered;
  }
  if (const glm::vec3* point = findWithin(place, safe)) {
    hint.points[hint.next] = *point;
    hint.next = (hint.next + 1) % hint.points.size();
    hint.count = std::min(hint.count + 1, hint.points.size());
    return covered;
  }
  const float distance = distanceWithin(place, (1 + kBand) * gap_);
  return std::min(covered, std::clamp((gap_ - distance) / gap_, -kBand, kBand));
}

bool SupportMargin::mayStay(const glm::vec3& centre, float reach) const {
  return findWithin(centre, (1 + kBand) * gap_ + reach) != nullptr;
}

// Most places near the surface have a point within a spacing: a small search finds it sooner.
const glm::vec3* SupportMargin::findWithin(const glm::vec3& place, float radius) const {
  const glm::vec3* found = nullptr;
  for (const float r : {std::min(radius, spacing_), radius}) {
    grid_.forEachRun(place, r, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last && !found; ++i) {
        const glm::vec3 d = sorted_[i] - place;
        if (glm::dot(d, d) < r * r) found = &sorted_[i];
      }
    });
    if (found || r == radius) break;
  }
  return found;
}

float SupportMargin::distanceWithin(const glm::vec3& place, float radius) const {
  float squared = radius * radius;
  grid_.forEachRun(place, radius, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const glm::vec3 d = sorted_[i] - place;
      squared = std::min(squared, glm::dot(d, d));
    }
  });
  return std::sqrt(squared);
}

}  // namespace sonoskin
