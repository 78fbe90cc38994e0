#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/mesh/point_grid.h"

namespace sonoskin {

// SupportMargin: how far a place of the surface is from where it would be cut off: where the nearest point is farther
// than the gap, or the coverage is below its limit.
class SupportMargin {
 public:
  static constexpr float kBand = 0.5f;

  // spacing    of the points, mm; saves time only
  // gap        mm, > 0
  // coverage   Σφ at which the surface ends; 0: anywhere
  SupportMargin(const std::vector<glm::vec3>& points, float spacing, float gap, float coverage);

  // Hint: the points that were near the last places asked for; they save searches for the next ones around.
  struct Hint {
    std::array<glm::vec3, 8> points{};
    std::size_t count = 0, next = 0;
  };
  // at: in [-kBand, kBand], > 0 where the surface stays: the distance left as a share of the gap, or what the coverage
  // has more than its limit as a share of that, whichever is less.
  float at(const glm::vec3& place, float coverage, Hint& hint) const;

  // mayStay: false only if at() is -kBand everywhere within `reach` of a centre.
  bool mayStay(const glm::vec3& centre, float reach) const;

 private:
  // A point closer than `radius`, or none.
  const glm::vec3* findWithin(const glm::vec3& place, float radius) const;
  // Distance to the nearest point, or `radius` if none is nearer.
  float distanceWithin(const glm::vec3& place, float radius) const;

  float spacing_, gap_, coverage_;
  PointGrid grid_;
  std::vector<glm::vec3> sorted_;
};

}  // namespace sonoskin
