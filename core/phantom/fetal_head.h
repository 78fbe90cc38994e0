#pragma once

#include <glm/glm.hpp>

namespace sonoskin {

// The head of the phantom in its own frame, mm: x toward the baby's left, y up, z forward; the origin lies
// between the ears at the height of the eyes. 75 mm across, 93 mm from crown to chin.

// headSkin: signed distance to the skin of head and neck; negative inside.
//   output   Lipschitz constant below 1.2; gradient within 0.2 of unit length at the surface
//   cost     0.3 us near the face
float headSkin(const glm::vec3& p);

// headBone: signed distance to the skull, a shell with orbits, nasal aperture and sutures, and the neck's
// spine.
float headBone(const glm::vec3& p);

}  // namespace sonoskin
