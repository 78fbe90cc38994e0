#include "core/phantom/hand_pose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/phantom/fetal_body.h"

namespace sonoskin {
namespace {

using glm::vec3;

float ball(const vec3& p) { return glm::length(p) - 40; }

// deepest: how far the hand's flesh reaches into a skin.
float deepest(const Arm& arm) {
  float d = ball(arm.hand.wrist.at) - arm.hand.wrist.radius;
  for (const Finger& finger : arm.hand.fingers)
    for (const sdf::Joint& j : finger) d = std::min(d, ball(j.at) - j.radius);
  for (const sdf::Joint& j : arm.hand.ball) d = std::min(d, ball(j.at) - j.radius);
  for (const sdf::Joint& j : arm.hand.thumb) d = std::min(d, ball(j.at) - j.radius);
  return std::min(d, ball(arm.hand.heel.at) - arm.hand.heel.radius);
}

TEST(HandPose, FindsTheSkin) {
  const vec3 p = skinToward(ball, {3, 0, 0}, {0, 1, 1});
  EXPECT_NEAR(ball(p), 0, 2e-3);
  EXPECT_NEAR(p.x, 3, 1e-3);
  EXPECT_NEAR(glm::distance(slopeOf(ball, p), glm::normalize(p)), 0, 1e-3);
}

TEST(HandPose, HandLiesOnTheSkinWithItsBackOutward) {
  for (const bool right : {false, true}) {
    const HandPlace place{{right ? -1.f : 1.f, 0.2f, 1}, {0, 1, 0}, right};
    const Arm arm = reachFor(firstArm(), place, ball, vec3(right ? -1 : 1, 1, 1) * kShoulder);
    EXPECT_NEAR(deepest(arm), -0.8, 0.06);
    const vec3 knuckle = arm.hand.fingers[1][0].at, tip = arm.hand.fingers[1][3].at;
    EXPECT_GT(tip.y, knuckle.y + 8) << "fingers up";
    EXPECT_GT(glm::dot(glm::normalize(knuckle), glm::normalize(place.knuckles)), 0.9f);
    const vec3 thumb = arm.hand.thumb[3].at;
    EXPECT_GT(thumb.x * (right ? 1 : -1), knuckle.x * (right ? 1 : -1)) << "thumbs toward each other";
    EXPECT_NEAR(glm::distance(arm.hand.fingers[1][0].at, arm.hand.fingers[1][3].at),
                glm::distance(firstArm().hand.fingers[1][0].at, firstArm().hand.fingers[1][3].at), 1e-3);
  }
}

TEST(HandPose, ArmsKeepTheirLengthWhereTheyReach) {
  const Arm first = firstArm();
  const float upper = glm::distance(first.shoulder, first.elbow);
  const float lower = glm::distance(first.elbow, first.hand.wrist.at);
  const Arm near = reachFor(first, {{1, -0.4f, 1}, {0, 1, 0}}, ball, kShoulder);
  EXPECT_NEAR(glm::distance(near.shoulder, near.elbow), upper, 0.1);
  EXPECT_NEAR(glm::distance(near.elbow, near.hand.wrist.at), lower, 0.1);
  const Arm far = reachFor(first, {{0.2f, 1, 0.3f}, {0, 1, 0}}, ball, kShoulder);
  EXPECT_GT(glm::distance(far.shoulder, far.elbow), upper + 2) << "longer where they do not";
}

TEST(HandPose, ScaledArmIsTheSameArm) {
  const Arm large = scaledArm(firstArm(), 1.25f);
  for (const vec3& p : {vec3(20, -30, 50), vec3(45, -80, 30), vec3(33, -50, 30)}) {
    EXPECT_NEAR(forearmSkin(1.25f * p, large), 1.25f * forearmSkin(p, firstArm()), 0.3);
    EXPECT_NEAR(armBone(1.25f * p, large), 1.25f * armBone(p, firstArm()), 1e-3);
  }
  EXPECT_EQ(armSkin({20, -30, 50}, firstArm()), firstArmSkin({20, -30, 50}));
}

TEST(HandPose, WithdrawsAHandThatIsBuried) {
  Arm arm = firstArm();  // its fingers lie within a ball of 40 mm around the head's middle
  withdrawHand(arm, [](const vec3& p) { return ball(p) - 20; }, {0, 0, 1});
  EXPECT_GT(arm.hand.wrist.at.z, firstArm().hand.wrist.at.z + 4);
  EXPECT_EQ(arm.elbow, firstArm().elbow);
}

}  // namespace
}  // namespace sonoskin
