#include "core/phantom/fetal_body.h"

#include <array>

#include "core/phantom/sdf.h"

namespace sonoskin {
namespace {

using namespace sdf;

constexpr vec3 kWrist{30, -52, 36}, kElbow{45, -82, 20}, kShoulder{34, -57, -4};

// A finger: knuckle, two joints, tip.
using Finger = std::array<Joint, 4>;
constexpr std::array<Finger, 4> kFingers{{
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
}};
constexpr std::array<Joint, 4> kThumb{
    {{{24, -48, 37}, 4.2f}, {{15, -45, 39}, 3.7f}, {{9, -40, 40.5f}, 3.2f}, {{6.5f, -36, 40.5f}, 2.7f}}};

}  // namespace

float bodySkin(const glm::vec3& p) {
  const vec3 q{std::abs(p.x), p.y, p.z};
  float d = ellipsoid(p, {0, -88, -10}, {37, 40, 29});                                    // chest
  d = smoothMin(d, capsule(q, {{4, -53, -14}, 15}, {kShoulder - vec3(4, 1, 2), 13}), 9);  // shoulders
  return smoothMin(d, capsule(p, {{-37, -60, -5}, 11.5f}, {{-50, -102, 0}, 9}), 4);       // right arm
}

float armSkin(const glm::vec3& p) {
  float d = capsule(p, {kShoulder, 12}, {kElbow, 9.5f});
  d = smoothMin(d, capsule(p, {kElbow, 9.2f}, {kWrist, 6.6f}), 3);
  if (!Reach{{20, -37, 38}, 26}.joins(p, d, 4)) return d;
  constexpr std::array<Joint, 2> ball{{{{17, -43, 37}, 5}, {{28, -43.5f, 34.5f}, 4.8f}}};
  float hand = smoothMin(capsule(p, {kWrist, 6}, {{22, -44, 37}, 5.6f}), chain(p, ball, 1), 4);  // palm
  for (const Finger& finger : kFingers) hand = smoothMin(hand, chain(p, finger, 0.8f), 1);
  hand = smoothMin(hand, chain(p, kThumb, 0.8f), 1.2f);
  return smoothMin(d, hand, 2.5f);
}

float bodyBone(const glm::vec3& p) {
  const float chest = ellipsoid(p, {0, -88, -10}, {31, 35, 24});
  const float rib = std::cos(0.75f * (p.y + 0.25f * p.z)) * 1.4f - 0.2f;
  const float ribs = std::max({chest, -(chest + 1.8f), rib});
  return std::min(ribs, capsule({std::abs(p.x), p.y, p.z}, {{3, -59, 4}, 1.4f}, {kShoulder, 1.6f}));
}

float armBone(const glm::vec3& p) {
  float d = std::min(capsule(p, {kShoulder, 2.4f}, {kElbow, 2.2f}), capsule(p, {kElbow, 2}, {kWrist, 1.6f}));
  for (const Finger& finger : kFingers) {
    d = std::min(d, capsule(p, {kWrist, 0.9f}, {finger[0].at, 1}));
    for (int i = 0; i < 3; ++i)
      d = std::min(d, capsule(p, {finger[std::size_t(i)].at, 0.9f}, {finger[std::size_t(i) + 1].at, 0.8f}));
  }
  for (std::size_t i = 0; i < 3; ++i)
    d = std::min(d, capsule(p, {kThumb[i].at, 1}, {kThumb[i + 1].at, 0.9f}));
  return d;
}

}  // namespace sonoskin
