#pragma once

#include <glm/glm.hpp>

namespace sonoskin {

// The head of the phantom in its own frame, mm: x toward the baby's left, y up, z forward; the origin lies
// between the ears at the height of the eyes. 75 mm across, 92 mm from crown to chin.

// headSkin: signed distance to the skin of head and neck; negative inside.
//   output   gradient of unit length at the surface but for creases, where it is shorter; Lipschitz constant
//            below 1.25 but for the depths of the face, more than 4 mm below the skin
//   cost     0.3 us near the face
float headSkin(const glm::vec3& p);

// headBone: signed distance to the skull, a shell with orbits, nasal aperture and fontanelle, and the spine.
float headBone(const glm::vec3& p);

}  // namespace sonoskin
