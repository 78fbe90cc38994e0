#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/phantom/sdf.h"

namespace sonoskin {

// Hand: its joints, each with the radius of the flesh around it. A finger: knuckle, two joints, tip.
using Finger = std::array<sdf::Joint, 4>;
struct Hand {
  sdf::Joint wrist, heel;          // the palm lies between the two
  std::array<sdf::Joint, 2> ball;  // across the palm, under the knuckles
  std::array<Finger, 4> fingers;   // from the index finger to the little one
  std::array<sdf::Joint, 4> thumb;
  sdf::Reach reach;  // a ball around all of it
};

// Arm: from shoulder to fingertips, in the head's frame (fetal_head.h), mm.
struct Arm {
  glm::vec3 shoulder, elbow;
  Hand hand;
  float size = 1;  // of the flesh and bones of the arm
};

// firstArm: the left arm, bent so that the hand lies beside the mouth, the backs of its fingers toward the
// probe.
Arm firstArm();

// armSkin: signed distance to the skin of an arm with its hand. firstArmSkin: of firstArm(), with its numbers known
// to the compiler: a little faster, and other roundings.
float armSkin(const glm::vec3& p, const Arm& arm);
float firstArmSkin(const glm::vec3& p);

// forearmSkin, upperArmSkin: of hand and forearm, and of the rest, as far as one must know which is nearer.
float forearmSkin(const glm::vec3& p, const Arm& arm);
float upperArmSkin(const glm::vec3& p, const Arm& arm);

// armBone: signed distance to the bones of an arm with its hand. firstArmBone: of firstArm(), as firstArmSkin.
float armBone(const glm::vec3& p, const Arm& arm);
float firstArmBone(const glm::vec3& p);

}  // namespace sonoskin
