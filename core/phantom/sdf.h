#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <span>

// Signed distances: negative inside, mm. Smooth unions keep the Lipschitz constant 1.
// [Quilez, "distance functions"]
namespace sonoskin::sdf {

using glm::vec3;

// smoothMin: min(a, b), rounded where the two differ by less than k; never above min, at most k/6 below it.
inline float smoothMin(float a, float b, float k) {
  const float h = std::max(k - std::abs(a - b), 0.f) / k;
  return std::min(a, b) - h * h * h * k * (1.f / 6);
}

// smoothMax: max(a, b), rounded; smoothMax(d, -c, k) carves c out of d.
inline float smoothMax(float a, float b, float k) { return -smoothMin(-a, -b, k); }

inline float sphere(const vec3& p, const vec3& centre, float radius) {
  return glm::distance(p, centre) - radius;
}

// ellipsoid: exact to first order at its surface, an estimate elsewhere.
inline float ellipsoid(const vec3& p, const vec3& centre, const vec3& radii) {
  const vec3 a = (p - centre) / radii, b = a / radii;
  const float k0 = glm::length(a), k1 = glm::length(b);
  return k1 < 1e-9f ? -std::min({radii.x, radii.y, radii.z}) : k0 * (k0 - 1) / k1;
}

// Joint: a point of a limb and its radius there.
struct Joint {
  vec3 at;
  float radius;
};

// capsule: a rounded cone between two joints.
inline float capsule(const vec3& p, const Joint& a, const Joint& b) {
  const vec3 pa = p - a.at, ba = b.at - a.at;
  const float t = std::clamp(glm::dot(pa, ba) / glm::dot(ba, ba), 0.f, 1.f);
  return glm::length(pa - ba * t) - (a.radius + (b.radius - a.radius) * t);
}

// chain: capsules from joint to joint, melted over `k`.
inline float chain(const vec3& p, std::span<const Joint> joints, float k) {
  float d = capsule(p, joints[0], joints[1]);
  for (std::size_t i = 1; i + 1 < joints.size(); ++i)
    d = smoothMin(d, capsule(p, joints[i], joints[i + 1]), k);
  return d;
}

// bump: 1 at x = 0, 0 from |x| = 1 on, smooth; its slope is at most 1.54. A relief of height h on a surface
// keeps the Lipschitz constant below 1.2 where h <= 0.43 times its half width.
inline float bump(float x) {
  const float h = std::max(1 - x * x, 0.f);
  return h * h;
}

// Reach: a ball around a detail of a shape. Outside its influence the detail need not be evaluated: smoothMin
// and smoothMax return their other argument there.
struct Reach {
  vec3 centre;
  float radius;
  bool joins(const vec3& p, float d, float k) const { return below(p, d + k); }
  bool carves(const vec3& p, float d, float k) const { return below(p, k - d); }

 private:
  bool below(const vec3& p, float limit) const {
    const float r = radius + limit;
    const vec3 q = p - centre;
    return r > 0 && glm::dot(q, q) < r * r;
  }
};

}  // namespace sonoskin::sdf
