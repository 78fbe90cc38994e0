#pragma once

#include <glm/glm.hpp>

#include "render/camera.h"

namespace sonoskin {

// The lamp dial: all directions from which light can come, as a camera shows them on a disk. Inside its rim (radius 1)
// they lie as on a ball that is seen from before it; what is behind follows outside, from the rim to kDialEdge.
inline constexpr float kDialEdge = 1.3f;

// dialPlace: where a direction lies on the dial; x to the right, y up.
//   direction  unit, toward the light
glm::vec2 dialPlace(const glm::vec3& direction, const Camera& camera);

// dialDirection: the direction that lies there, its inverse; places beyond the edge count as on it.
glm::vec3 dialDirection(const glm::vec2& place, const Camera& camera);

}  // namespace sonoskin
