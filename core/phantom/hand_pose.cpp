#include "core/phantom/hand_pose.h"

#include <cmath>
#include <limits>

namespace sonoskin {
namespace {

using namespace sdf;

template <class F>
void eachJoint(Hand& hand, F&& f) {
  f(hand.wrist);
  f(hand.heel);
  for (Joint& j : hand.ball) f(j);
  for (Finger& finger : hand.fingers)
    for (Joint& j : finger) f(j);
  for (Joint& j : hand.thumb) f(j);
}

void shift(Hand& hand, const vec3& by) {
  eachJoint(hand, [&](Joint& j) { j.at += by; });
  hand.reach.centre += by;
}

vec3 knuckles(const Hand& hand) {
  vec3 sum(0);
  for (const Finger& finger : hand.fingers) sum += finger[0].at;
  return 0.25f * sum;
}

// handAxes: columns: from the index finger to the little one, along the fingers, out of the back of the hand.
glm::mat3 handAxes(const Hand& hand) {
  const vec3 along = glm::normalize(knuckles(hand) - hand.wrist.at);
  const vec3 across = glm::normalize(hand.fingers[3][0].at - hand.fingers[0][0].at);
  const vec3 back = glm::normalize(glm::cross(across, along));
  return {glm::cross(along, back), along, back};
}

float clearance(const Hand& hand, const SkinFunction& skin) {
  float least = std::numeric_limits<float>::infinity();
  Hand copy = hand;
  eachJoint(copy, [&](const Joint& j) { least = std::min(least, skin(j.at) - j.radius); });
  return least;
}

void bendElbow(Arm& arm, float upper, float lower, const vec3& hint) {
  const vec3 straight = arm.hand.wrist.at - arm.shoulder;
  const float reach = glm::length(straight), stretch = std::max(1.f, 1.02f * reach / (upper + lower));
  const float a = upper * stretch, b = lower * stretch;
  const vec3 along = straight / reach;
  const float first = glm::clamp((a * a - b * b + reach * reach) / (2 * reach), -a, a);
  const vec3 aside = glm::normalize(hint - along * glm::dot(hint, along));
  arm.elbow = arm.shoulder + along * first + aside * std::sqrt(std::max(a * a - first * first, 0.f));
}

}  // namespace

glm::vec3 skinToward(const SkinFunction& skin, const glm::vec3& middle, const glm::vec3& direction) {
  constexpr float kFrom = 110, kClose = 1e-3f;
  const vec3 along = glm::normalize(direction);
  float t = kFrom;
  for (float d = skin(middle + along * t); d > kClose && t > 0; d = skin(middle + along * t)) t -= 0.7f * d;
  return middle + along * std::max(t, 0.f);
}

glm::vec3 slopeOf(const SkinFunction& skin, const glm::vec3& p) {
  constexpr float h = 0.05f;
  vec3 slope;
  for (int axis = 0; axis < 3; ++axis) {
    vec3 step(0);
    step[axis] = h;
    slope[axis] = (skin(p + step) - skin(p - step)) / (2 * h);
  }
  return slope;
}

Arm scaledArm(const Arm& arm, float size) {
  Arm out = arm;
  out.shoulder *= size;
  out.elbow *= size;
  eachJoint(out.hand, [&](Joint& j) { j = {j.at * size, j.radius * size}; });
  out.hand.reach = {arm.hand.reach.centre * size, arm.hand.reach.radius * size};
  out.size = arm.size * size;
  return out;
}

void withdrawHand(Arm& arm, const SkinFunction& skin, const glm::vec3& direction) {
  constexpr float kPressed = -0.8f;
  constexpr int kSteps = 30;
  const vec3 away = glm::normalize(direction);
  for (int step = 0; step < kSteps; ++step) {
    const float missing = kPressed - clearance(arm.hand, skin);
    if (std::abs(missing) < 0.05f) return;
    shift(arm.hand, away * glm::clamp(0.8f * missing, -6.f, 6.f));
  }
}

Arm reachFor(const Arm& arm, const HandPlace& place, const SkinFunction& skin, const glm::vec3& shoulder) {
  constexpr float kAbove = 10;  // mm, to begin with
  const float mirror = place.right ? -1.f : 1.f;
  const vec3 under = skinToward(skin, vec3(0, -5, 5) * arm.size, place.knuckles);
  const vec3 back =
      glm::normalize(0.5f * glm::normalize(slopeOf(skin, under)) + glm::normalize(place.knuckles));
  const vec3 along = glm::normalize(place.fingers - back * glm::dot(place.fingers, back));
  const glm::mat3 axes = handAxes(arm.hand), laid{mirror * glm::cross(along, back), along, back};
  const glm::mat3 turn = laid * glm::transpose(axes);
  const vec3 from = knuckles(arm.hand), to = under + back * kAbove;
  Arm out = arm;
  eachJoint(out.hand, [&](Joint& j) { j.at = to + turn * (j.at - from); });
  out.hand.reach.centre = to + turn * (arm.hand.reach.centre - from);
  out.shoulder = shoulder;
  withdrawHand(out, skin, back);
  bendElbow(out, glm::distance(arm.shoulder, arm.elbow), glm::distance(arm.elbow, arm.hand.wrist.at),
            {0.8f * mirror, -0.5f, 0.1f});
  return out;
}

}  // namespace sonoskin
