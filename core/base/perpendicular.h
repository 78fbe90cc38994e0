#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace sonoskin {

// AxisChoice: which coordinate axis helps to find what is perpendicular to a direction: the first one, or the second
// where the direction's component along the first reaches the limit. A choice decides how a frame lies around its
// axis, so that another one gives other samples, though none that are worse.
struct AxisChoice {
  int first, second;
  double limit = 0.9;
};

// axisAside: the coordinate axis that is chosen for the unit vector n; far from parallel to it.
template <class Vector>
Vector axisAside(const Vector& n, const AxisChoice& choice) {
  Vector axis(0);
  axis[std::abs(n[choice.first]) < typename Vector::value_type(choice.limit) ? choice.first : choice.second] =
      1;
  return axis;
}

// perpendicularTo: a unit vector perpendicular to the unit vector n: n x axisAside.
template <class Vector>
Vector perpendicularTo(const Vector& n, const AxisChoice& choice) {
  return glm::normalize(glm::cross(n, axisAside(n, choice)));
}

}  // namespace sonoskin
