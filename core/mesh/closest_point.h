#pragma once

#include <glm/glm.hpp>

namespace sonoskin {

// ClosestPoint: the place of a triangle nearest to a query, as barycentric weights of its corners.
struct ClosestPoint {
  glm::vec3 position{0};
  glm::vec3 weights{1, 0, 0};
};

// closestPointOnSegment: on the side from corner `first` to corner `second` of a triangle.
inline ClosestPoint closestPointOnSegment(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b,
                                          int first, int second) {
  const glm::vec3 ab = b - a;
  const float squared = glm::dot(ab, ab);
  const float t = squared > 0 ? glm::clamp(glm::dot(p - a, ab) / squared, 0.f, 1.f) : 0.f;
  ClosestPoint place{a + t * ab, glm::vec3(0)};
  place.weights[first] = 1 - t;
  place.weights[second] += t;
  return place;
}

// closestPointOnLine: of a triangle without area: the nearest on its sides.
inline ClosestPoint closestPointOnLine(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b,
                                       const glm::vec3& c) {
  ClosestPoint best = closestPointOnSegment(p, a, b, 0, 1);
  for (const ClosestPoint& other :
       {closestPointOnSegment(p, b, c, 1, 2), closestPointOnSegment(p, c, a, 2, 0)})
    if (glm::distance(p, other.position) < glm::distance(p, best.position)) best = other;
  return best;
}

// closestPointOnTriangle: exact, also for triangles without area.
//   method   the corner, edge or inside region in which the query's projection lies       [Ericson 2005, ch. 5.1.5]
inline ClosestPoint closestPointOnTriangle(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b,
                                           const glm::vec3& c) {
  const glm::vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {a, {1, 0, 0}};
  const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {b, {0, 1, 0}};
  const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {c, {0, 0, 1}};
  const float vc = d1 * d4 - d3 * d2;
  const float squaredAb = d1 - d3;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && squaredAb > 0) {
    const float t = d1 / squaredAb;
    return {a + t * ab, {1 - t, t, 0}};
  }
  const float vb = d5 * d2 - d1 * d6;
  const float squaredAc = d2 - d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && squaredAc > 0) {
    const float t = d2 / squaredAc;
    return {a + t * ac, {1 - t, 0, t}};
  }
  const float va = d3 * d6 - d5 * d4;
  const float squaredBc = (d4 - d3) + (d5 - d6);
  if (va <= 0 && d4 >= d3 && d5 >= d6 && squaredBc > 0) {
    const float t = (d4 - d3) / squaredBc;
    return {b + t * (c - b), {0, 1 - t, t}};
  }
  const float squaredArea = va + vb + vc;  // times four
  if (squaredArea <= 1e-6f * glm::dot(ab, ab) * glm::dot(ac, ac)) return closestPointOnLine(p, a, b, c);
  const float scale = 1 / squaredArea, v = vb * scale, w = vc * scale;
  return {a + v * ab + w * ac, {1 - v - w, v, w}};
}

}  // namespace sonoskin
