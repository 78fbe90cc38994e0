#pragma once

#include <glm/glm.hpp>

namespace sonoskin {

// The world of the simulated scan: mm, x toward the feet, y away from the probe, z toward the baby's left (as
// the first scene has it). The field of view is kFieldOfView, from the world's origin; the probe is at y = 0.
inline constexpr glm::dvec3 kFieldOfView{140.1, 76.5, 111.6};

// FacePlaces: where the face's parts lie on the baby's skin; world mm.
//   eyes   the middle of the closed lids; "right" and "left" are the baby's own
struct FacePlaces {
  glm::dvec3 rightEye, leftEye, noseTip, mouthRight, mouthLeft;
};

}  // namespace sonoskin
