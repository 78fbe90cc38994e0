#include "app/workspace/lamp_dial.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {

glm::vec2 dialPlace(const glm::vec3& direction, const Camera& camera) {
  const glm::vec2 across(glm::dot(direction, camera.right()), glm::dot(direction, camera.up));
  const float sine = std::min(glm::length(across), 1.f);
  const bool behind = glm::dot(direction, camera.forward) > 0;
  if (!behind) return across;
  const glm::vec2 toward = sine > 1e-6f ? across / glm::length(across) : glm::vec2(0, 1);
  return (1 + (kDialEdge - 1) * (1 - sine)) * toward;
}

glm::vec3 dialDirection(const glm::vec2& place, const Camera& camera) {
  const float r = std::min(glm::length(place), kDialEdge);
  const glm::vec2 toward = r > 1e-6f ? place / glm::length(place) : glm::vec2(0, 1);
  const bool behind = r > 1;
  const float sine = behind ? 1 - (r - 1) / (kDialEdge - 1) : r;
  const float depth = std::sqrt(std::max(0.f, 1 - sine * sine));
  return glm::normalize(sine * (toward.x * camera.right() + toward.y * camera.up) +
                        (behind ? depth : -depth) * camera.forward);
}

}  // namespace sonoskin
