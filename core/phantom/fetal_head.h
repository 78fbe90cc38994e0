#pragma once

#include <glm/glm.hpp>

#include "core/phantom/head_shape.h"

namespace sonoskin {

// The heads of the phantom in their own frame, mm: x toward the baby's left, y up, z forward; the origin lies
// between the ears at the height of the eyes. The first head is 75 mm across, 92 mm from crown to chin.

// headSkin: signed distance to the skin of head and neck; negative inside.
//   shape    which head; without it the first one, to the bit that of HeadShape{}
//   output   gradient of unit length at the surface but for creases, where it is shorter; Lipschitz constant
//            below 1.25 but for the depths of the face, more than 4 mm below the skin
//   cost     0.3 us near the face
float headSkin(const glm::vec3& p, const HeadShape& shape);
float headSkin(const glm::vec3& p);

// headBone: signed distance to the skull, a shell with orbits, nasal aperture and fontanelle, and the spine.
float headBone(const glm::vec3& p, const HeadShape& shape);
float headBone(const glm::vec3& p);

// HeadPlaces: where the parts of a face lie on its skin, in the head's frame.
//   eyes   the middle of the closed lids; "right" and "left" are the baby's own
//   chin   the middle of its front
struct HeadPlaces {
  glm::vec3 rightEye{0}, leftEye{0}, noseTip{0}, mouthRight{0}, mouthLeft{0}, chin{0};
};
HeadPlaces headPlaces(const HeadShape& shape);

}  // namespace sonoskin
