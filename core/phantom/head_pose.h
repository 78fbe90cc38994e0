#pragma once

#include <glm/glm.hpp>

namespace sonoskin {

// HeadTurn: how the head lies, rad: 0 looks straight at the probe, its crown toward -x.
//   yaw     to its right (toward world -z)
//   pitch   bowed, the chin on the chest
//   roll    tilted in the plane of the picture, the crown toward the baby's right
struct HeadTurn {
  double yaw = 0.17, pitch = 0.05, roll = -0.06;
};

// HeadPose: the head's frame (fetal_head.h) in the world of the scan; a rigid motion.
struct HeadPose {
  glm::vec3 centre;  // world mm, of the head's origin
  glm::mat3 worldToHead;

  glm::vec3 toHead(const glm::dvec3& world) const { return worldToHead * (glm::vec3(world) - centre); }
  glm::dvec3 toWorld(const glm::vec3& head) const {
    return glm::dvec3(glm::transpose(worldToHead) * head + centre);
  }
};

// headPose: the pose of a head with its origin at `centre`, world mm. turnAbout: the rotation of a frame by
// bow * turn * tilt alone, without the change of axes.
HeadPose headPose(const HeadTurn& turn, const glm::vec3& centre);
glm::dmat3 turnAbout(const HeadTurn& turn);

}  // namespace sonoskin
