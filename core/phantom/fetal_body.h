#pragma once

#include <glm/glm.hpp>

namespace sonoskin {

// The body of the phantom in the head's frame (see fetal_head.h), mm: shoulders, chest, and the left arm,
// bent so that the hand lies beside the mouth, the backs of its fingers toward the probe.

// bodySkin, armSkin: signed distance to the skin of trunk and right arm, and of left arm and hand.
float bodySkin(const glm::vec3& p);
float armSkin(const glm::vec3& p);

// bodyBone, armBone: signed distance to ribs and collar bones, and to the bones of the left arm and hand.
float bodyBone(const glm::vec3& p);
float armBone(const glm::vec3& p);

}  // namespace sonoskin
