#pragma once

#include <glm/glm.hpp>

namespace sonoskin {

// The trunk of the phantom in the frame of a head that looks straight ahead (see fetal_head.h), mm.

// Where the trunk turns beside the head, and where the arms begin: the left one; the right one is its mirror.
inline constexpr glm::vec3 kNeck{0, -42, -8}, kShoulder{34, -57, -4};

// bodySkin: signed distance to the skin of chest and shoulders. rightArmSkin: of a right arm that hangs down.
float bodySkin(const glm::vec3& p);
float rightArmSkin(const glm::vec3& p);

// bodyBone: signed distance to ribs and collar bones.
float bodyBone(const glm::vec3& p);

}  // namespace sonoskin
