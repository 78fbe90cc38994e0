#pragma once

#include <array>
#include <glm/glm.hpp>

#include "render/slice_axes.h"

namespace sonoskin {

// PlaneDirections: how a slice lies that need not lie along the axes of the volume: what runs to the right in its picture and
// what downward. World, unit, perpendicular to each other.
struct PlaneDirections {
  glm::dvec3 right{1, 0, 0}, down{0, 1, 0};

  // normal: away from who looks at the picture.
  glm::dvec3 normal() const { return glm::cross(right, down); }
  friend bool operator==(const PlaneDirections&, const PlaneDirections&) = default;
};

// directionsOf: those of one of the three planes.
PlaneDirections directionsOf(const Geometry& geometry, const SliceAxes& axes);

// ObliqueAngles: how a plane is turned against another one, degrees: the other one is turned first in its picture, clockwise, then
// about what runs downward there, then about what runs to the right.
//   tilt  about the right; -180 to 180
//   turn  about what runs downward; -90 to 90
//   roll  in the picture; -180 to 180
struct ObliqueAngles {
  double tilt = 0, turn = 0, roll = 0;
};

// anglesOf, directionsAt: from directions to angles and back. Where the turn is 90 degrees, tilt and roll are one: the roll.
ObliqueAngles anglesOf(const PlaneDirections& plane, const PlaneDirections& base);
PlaneDirections directionsAt(const ObliqueAngles& angles, const PlaneDirections& base);

// turnedAbout: the directions turned about an axis.
//   axis     world, unit
//   radians  counter-clockwise for who sees the axis come toward him
PlaneDirections turnedAbout(const PlaneDirections& plane, const glm::dvec3& axis, double radians);

}  // namespace sonoskin
