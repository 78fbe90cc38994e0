#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <optional>

#include "app/views/pane.h"
#include "render/camera.h"

namespace sonoskin::ui {

// pixelsPerTangent: pixels of the screen per mm at a distance of 1 mm from the eye.
inline float pixelsPerTangent(const Camera& camera, const PaneInput& pane) {
  return 0.5f * pane.size.y / std::tan(0.5f * glm::radians(camera.fieldOfView));
}

// seenAt: where on the screen a place of the world is seen in a pane; nothing for what is behind the eye.
inline std::optional<glm::vec2> seenAt(const glm::vec3& world, const Camera& camera, const PaneInput& pane) {
  constexpr float kNearest = 0.003f;  // of the camera's distance
  const glm::vec3 p(camera.view() * glm::vec4(world, 1));
  if (p.z > -kNearest * camera.distance) return std::nullopt;
  return pane.corner + 0.5f * pane.size + pixelsPerTangent(camera, pane) * glm::vec2(p.x, -p.y) / -p.z;
}

// rayThrough: the unit direction from the eye through a place of the pane, from its upper left corner.
inline glm::vec3 rayThrough(const glm::vec2& mouse, const Camera& camera, const PaneInput& pane) {
  const glm::vec2 off = (mouse - 0.5f * pane.size) / pixelsPerTangent(camera, pane);
  return glm::normalize(camera.forward + off.x * camera.right() - off.y * camera.up);
}

}  // namespace sonoskin::ui
