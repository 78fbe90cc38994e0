#include "core/phantom/fetal_arm.h"

namespace sonoskin {
namespace {

using namespace sdf;

constexpr Hand kFirstHand{
    {{30, -52, 36}, 6},
    {{22, -44, 37}, 5.6f},
    {{{{17, -43, 37}, 5}, {{28, -43.5f, 34.5f}, 4.8f}}},
    {{
        {{{{14, -39.5f, 40}, 3.4f},
          {{11.8f, -34, 43.5f}, 3.2f},
          {{12.5f, -27.8f, 42.5f}, 2.9f},
          {{13.7f, -24, 39.5f}, 2.5f}}},
        {{{{20, -38, 40}, 3.5f},
          {{18.2f, -31.5f, 43}, 3.3f},
          {{18.8f, -24.8f, 41}, 3},
          {{19.5f, -20.8f, 37.5f}, 2.6f}}},
        {{{{26, -38.5f, 38}, 3.4f},
          {{25, -32.3f, 40.8f}, 3.2f},
          {{25.2f, -25.8f, 38.5f}, 2.9f},
          {{25.3f, -22, 35.2f}, 2.5f}}},
        {{{{31.5f, -41, 35}, 3},
          {{31.5f, -35.5f, 37}, 2.8f},
          {{31.2f, -30.3f, 34.8f}, 2.5f},
          {{30.8f, -27.5f, 32}, 2.2f}}},
    }},
    {{{{24, -48, 37}, 4.2f}, {{15, -45, 39}, 3.7f}, {{9, -40, 40.5f}, 3.2f}, {{6.5f, -36, 40.5f}, 2.7f}}},
    {{20, -37, 38}, 26}};

constexpr Arm kFirstArm{{34, -57, -4}, {45, -82, 20}, kFirstHand};

[[gnu::always_inline]] inline float handOf(const vec3& p, const Hand& h) {
  float d = smoothMin(capsule(p, h.wrist, h.heel), chain(p, h.ball, 1), 4);  // palm
  for (const Finger& finger : h.fingers) d = smoothMin(d, chain(p, finger, 0.8f), 1);
  return smoothMin(d, chain(p, h.thumb, 0.8f), 1.2f);
}

inline float upperArmOf(const vec3& p, const Arm& a) {
  return capsule(p, {a.shoulder, 12 * a.size}, {a.elbow, 9.5f * a.size});
}

inline float forearmOf(const vec3& p, const Arm& a) {
  return capsule(p, {a.elbow, 9.2f * a.size}, {a.hand.wrist.at, 6.6f * a.size});
}

[[gnu::always_inline]] inline float armOf(const vec3& p, const Arm& a) {
  const float d = smoothMin(upperArmOf(p, a), forearmOf(p, a), 3);
  return a.hand.reach.joins(p, d, 4) ? smoothMin(d, handOf(p, a.hand), 2.5f) : d;
}

[[gnu::always_inline]] inline float armBoneOf(const vec3& p, const Arm& a) {
  const float s = a.size;
  const vec3& wrist = a.hand.wrist.at;
  float d = std::min(capsule(p, {a.shoulder, 2.4f * s}, {a.elbow, 2.2f * s}),
                     capsule(p, {a.elbow, 2 * s}, {wrist, 1.6f * s}));
  for (const Finger& finger : a.hand.fingers) {
    d = std::min(d, capsule(p, {wrist, 0.9f * s}, {finger[0].at, s}));
    for (std::size_t i = 0; i < 3; ++i)
      d = std::min(d, capsule(p, {finger[i].at, 0.9f * s}, {finger[i + 1].at, 0.8f * s}));
  }
  for (std::size_t i = 0; i < 3; ++i)
    d = std::min(d, capsule(p, {a.hand.thumb[i].at, s}, {a.hand.thumb[i + 1].at, 0.9f * s}));
  return d;
}

}  // namespace

Arm firstArm() { return kFirstArm; }

float upperArmSkin(const glm::vec3& p, const Arm& a) { return upperArmOf(p, a); }

float forearmSkin(const glm::vec3& p, const Arm& a) {
  const float d = forearmOf(p, a);
  return a.hand.reach.joins(p, d, 4) ? smoothMin(d, handOf(p, a.hand), 2.5f) : d;
}

float armSkin(const glm::vec3& p, const Arm& a) { return armOf(p, a); }

float firstArmSkin(const glm::vec3& p) { return armOf(p, kFirstArm); }

float armBone(const glm::vec3& p, const Arm& a) { return armBoneOf(p, a); }

float firstArmBone(const glm::vec3& p) { return armBoneOf(p, kFirstArm); }

}  // namespace sonoskin
