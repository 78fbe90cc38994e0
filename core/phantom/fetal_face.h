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

// Of the phantom of the default options; see PhantomModel for others.
// skinDistance: signed distance to the baby's skin; negative inside.
//   world    mm
//   output   mm; |gradient| is 1 at the skin but for creases, where it is shorter; Lipschitz constant below
//            1.25 but for the depths of the face, more than 4 mm below the skin
//   cost     0.5 us
double skinDistance(const glm::dvec3& world);
FacePlaces facePlaces();

// boneDistance: signed distance to the baby's bones; negative inside.
double boneDistance(const glm::dvec3& world);

// wallDistance: signed distance to the uterine wall and the placenta; negative inside the mother's tissue.
double wallDistance(const glm::dvec3& world);

}  // namespace sonoskin
