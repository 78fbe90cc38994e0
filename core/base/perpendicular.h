#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace sonoskin {

template <class Vector>
constexpr Vector coordinateAxis(int axis) {
  return Vector(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
}

// axisAside: a coordinate axis that is far from parallel to the unit vector n: the first one, or the second where the
// component of n along the first reaches the limit. The choice decides how a frame lies around n, so that another one
// gives other samples, though none that are worse.
template <int first, int second, class Vector>
Vector axisAside(const Vector& n, double limit = 0.9) {
  return std::abs(n[first]) < typename Vector::value_type(limit) ? coordinateAxis<Vector>(first)
                                                                 : coordinateAxis<Vector>(second);
}

// perpendicularTo: a unit vector perpendicular to the unit vector n: n x axisAside.
template <int first, int second, class Vector>
Vector perpendicularTo(const Vector& n, double limit = 0.9) {
  return glm::normalize(glm::cross(n, axisAside<first, second>(n, limit)));
}

}  // namespace sonoskin
