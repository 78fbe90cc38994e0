#include "render/oblique_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace sonoskin {
namespace {

glm::dmat3 axesOf(const PlaneDirections& plane) { return {plane.right, plane.down, plane.normal()}; }

// Rounding of many turns does not add up.
PlaneDirections perpendicular(const glm::dvec3& right, const glm::dvec3& down) {
  const glm::dvec3 r = glm::normalize(right);
  return {r, glm::normalize(down - glm::dot(down, r) * r)};
}

glm::dmat3 rotation(double radians, const glm::dvec3& axis) {
  return glm::dmat3(glm::rotate(glm::dmat4(1), radians, axis));
}

}  // namespace

PlaneDirections directionsOf(const Geometry& geometry, const SliceAxes& axes) {
  return {(axes.rightGrows ? 1.0 : -1.0) * geometry.direction[axes.right],
          (axes.downGrows ? 1.0 : -1.0) * geometry.direction[axes.down]};
}

ObliqueAngles anglesOf(const PlaneDirections& plane, const PlaneDirections& base) {
  const glm::dmat3 m = glm::transpose(axesOf(base)) * axesOf(plane);  // tilt * turn * roll
  const double turn = std::asin(std::clamp(m[2].x, -1.0, 1.0));
  if (std::abs(m[2].x) > 1 - 1e-9) return {0, glm::degrees(turn), glm::degrees(std::atan2(m[0].y, m[1].y))};
  return {glm::degrees(std::atan2(-m[2].y, m[2].z)), glm::degrees(turn),
          glm::degrees(std::atan2(-m[1].x, m[0].x))};
}

PlaneDirections directionsAt(const ObliqueAngles& angles, const PlaneDirections& base) {
  const glm::dmat3 m = axesOf(base) * rotation(glm::radians(angles.tilt), {1, 0, 0}) *
                       rotation(glm::radians(angles.turn), {0, 1, 0}) *
                       rotation(glm::radians(angles.roll), {0, 0, 1});
  return perpendicular(m[0], m[1]);
}

PlaneDirections turnedAbout(const PlaneDirections& plane, const glm::dvec3& axis, double radians) {
  const glm::dmat3 m = rotation(radians, axis);
  return perpendicular(m * plane.right, m * plane.down);
}

}  // namespace sonoskin
