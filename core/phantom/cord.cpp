#include "core/phantom/cord.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sonoskin {
namespace {

using glm::vec3;

constexpr float kFar = 1000;

vec3 curve(const vec3& a, const vec3& b, const vec3& c, const vec3& d, float t) {
  return 0.5f * (2.f * b + (c - a) * t + (2.f * a - 5.f * b + 4.f * c - d) * (t * t) +
                 (3.f * b - a - 3.f * c + d) * (t * t * t));
}

// setFrames: distances along the axis, and directions across it that turn as little as possible.
void setFrames(std::vector<Cord::Node>& axis) {
  vec3 side(0.36f, 0.48f, 0.8f);
  for (std::size_t n = 0; n < axis.size(); ++n) {
    const vec3 along = glm::normalize(axis[std::min(n + 1, axis.size() - 1)].at - axis[n ? n - 1 : 0].at);
    side = glm::normalize(side - along * glm::dot(side, along));
    axis[n].side = side;
    axis[n].along = n ? axis[n - 1].along + glm::distance(axis[n].at, axis[n - 1].at) : 0;
  }
}

}  // namespace

Cord makeCord(const std::vector<glm::vec3>& guide, float radius) {
  constexpr int kSteps = 8;  // from point to point
  Cord cord;
  cord.radius = radius;
  for (std::size_t g = 1; g + 2 < guide.size(); ++g)
    for (int s = 0; s < kSteps; ++s)
      cord.axis.push_back(
          {curve(guide[g - 1], guide[g], guide[g + 1], guide[g + 2], float(s) / kSteps), {}, 0});
  if (cord.axis.empty()) return cord;
  cord.axis.push_back({guide[guide.size() - 2], {}, 0});
  setFrames(cord.axis);
  vec3 low(cord.axis[0].at), high(low);
  for (const Cord::Node& n : cord.axis) low = glm::min(low, n.at), high = glm::max(high, n.at);
  cord.reach = {0.5f * (low + high), 0.5f * glm::distance(low, high) + radius};
  return cord;
}

float cordDistance(const Cord& cord, const glm::vec3& p) {
  constexpr float kRelief = 0.09f, kPitch = 30, kEnough = 10;
  if (cord.axis.empty()) return kFar;
  if (!cord.reach.joins(p, 0, kEnough)) return glm::distance(p, cord.reach.centre) - cord.reach.radius;
  float nearest = std::numeric_limits<float>::infinity(), at = 0;
  std::size_t segment = 0;
  for (std::size_t n = 0; n + 1 < cord.axis.size(); ++n) {
    const vec3 ab = cord.axis[n + 1].at - cord.axis[n].at, ap = p - cord.axis[n].at;
    const float t = glm::clamp(glm::dot(ap, ab) / glm::dot(ab, ab), 0.f, 1.f);
    const vec3 off = ap - ab * t;
    if (const float d = glm::dot(off, off); d < nearest) nearest = d, at = t, segment = n;
  }
  const Cord::Node &a = cord.axis[segment], &b = cord.axis[segment + 1];
  const vec3 off = p - glm::mix(a.at, b.at, at), along = glm::normalize(b.at - a.at);
  const vec3 side = glm::mix(a.side, b.side, at);
  const float angle = std::atan2(glm::dot(off, glm::cross(along, side)), glm::dot(off, side));
  const float twist = glm::mix(a.along, b.along, at) * (6.2831853f / kPitch);
  return glm::length(off) - cord.radius * (1 - kRelief + kRelief * std::cos(3 * angle - twist));
}

}  // namespace sonoskin
