#include "core/phantom/fetal_body.h"

#include <array>

#include "core/phantom/sdf.h"

namespace sonoskin {
namespace {

using namespace sdf;

constexpr vec3 kWrist{30, -53, 36}, kElbow{46, -86, 16}, kShoulder{35, -66, -6};

// A finger: knuckle, two joints, tip.
using Finger = std::array<Joint, 4>;
constexpr std::array<Finger, 4> kFingers{{
    {{{{13.5f, -41, 40.5f}, 2.9f},
      {{10.5f, -34.5f, 45.5f}, 2.7f},
      {{12, -27, 43.5f}, 2.5f},
      {{13.5f, -22.5f, 40.5f}, 2.2f}}},
    {{{{19, -39, 40.5f}, 3},
      {{16.5f, -31.5f, 45}, 2.8f},
      {{17.5f, -23, 42}, 2.6f},
      {{18.5f, -18.5f, 38.5f}, 2.3f}}},
    {{{{24.3f, -39.5f, 39}, 2.9f},
      {{23, -32, 43}, 2.7f},
      {{23.5f, -24, 39.5f}, 2.5f},
      {{24, -19.8f, 36}, 2.2f}}},
    {{{{29, -41.5f, 36.5f}, 2.6f},
      {{29, -35.5f, 39.5f}, 2.4f},
      {{29, -29, 36}, 2.2f},
      {{29, -25.5f, 33}, 1.9f}}},
}};
constexpr std::array<Joint, 4> kThumb{
    {{{22, -50, 38}, 3.4f}, {{13, -46.5f, 39.5f}, 3.2f}, {{6, -41, 39.5f}, 2.8f}, {{2, -37, 40}, 2.4f}}};

}  // namespace

float bodySkin(const glm::vec3& p) {
  const vec3 q{std::abs(p.x), p.y, p.z};
  float d = ellipsoid(p, {0, -96, -12}, {37, 42, 29});                                    // chest
  d = smoothMin(d, capsule(q, {{4, -62, -14}, 14}, {kShoulder - vec3(3, 0, 0), 13}), 8);  // shoulders
  return smoothMin(d, capsule(p, {{-36, -68, -8}, 11}, {{-50, -108, -4}, 9}), 4);         // right arm
}

float armSkin(const glm::vec3& p) {
  float d = capsule(p, {kShoulder, 11.5f}, {kElbow, 9});
  d = smoothMin(d, capsule(p, {kElbow, 8.5f}, {kWrist, 6}), 3);
  if (!Reach{{20, -37, 38}, 26}.joins(p, d, 4)) return d;
  constexpr std::array<Joint, 2> ball{{{{15, -43.5f, 38}, 4}, {{27, -44, 36}, 3.8f}}};
  float hand = smoothMin(capsule(p, {kWrist, 5.2f}, {{21, -45, 38}, 5}), chain(p, ball, 1), 4);  // palm
  for (const Finger& finger : kFingers) hand = smoothMin(hand, chain(p, finger, 1), 0.8f);
  hand = smoothMin(hand, chain(p, kThumb, 1), 1);
  return smoothMin(d, hand, 3);
}

float bodyBone(const glm::vec3& p) {
  const float chest = ellipsoid(p, {0, -96, -12}, {31, 37, 24});
  const float rib = std::cos(0.75f * (p.y + 0.25f * p.z)) * 1.4f - 0.2f;
  const float ribs = std::max({chest, -(chest + 1.8f), rib});
  return std::min(ribs, capsule({std::abs(p.x), p.y, p.z}, {{3, -63, 6}, 1.4f}, {kShoulder, 1.6f}));
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
