#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/volume/volume.h"

namespace sonoskin {

// Plane: a slice across one axis of a volume. Seen so that depth (j), which is the beam's way in most scans,
// runs downward where it lies in the plane:
//   sagittal  across i: k to the right, j downward
//   coronal   across j: i to the right, k downward
//   axial     across k: i to the right, j downward
enum class Plane { sagittal, coronal, axial };
constexpr std::array<Plane, 3> kPlanes{Plane::axial, Plane::sagittal, Plane::coronal};

// planeColour: sRGB, 0 to 1: axial red, sagittal yellow, coronal green.
glm::vec3 planeColour(Plane plane);

// The volume's axis (0: i, 1: j, 2: k) across a plane, to its right, and downward in it.
constexpr int axisAcross(Plane plane) { return int(plane); }
constexpr int axisRight(Plane plane) { return plane == Plane::sagittal ? 2 : 0; }
constexpr int axisDown(Plane plane) { return plane == Plane::coronal ? 2 : 1; }

// SliceCamera: what part of which slice is seen.
//   cursor  world mm; the slice goes through it, and the cross-hair's lines meet there
//   pan     mm that the picture is moved to the right and downward
//   zoom    1: the whole slice just fits
struct SliceCamera {
  Plane plane = Plane::axial;
  glm::dvec3 cursor{0};
  glm::dvec2 pan{0};
  double zoom = 1;
};

// SliceFrame: from pixels (from the upper left corner; pixel centres at halves) to the world, mm:
// world = corner + x * right + y * down.
struct SliceFrame {
  glm::dvec3 corner{0}, right{1, 0, 0}, down{0, 1, 0};

  glm::dvec3 toWorld(const glm::dvec2& pixel) const { return corner + pixel.x * right + pixel.y * down; }
  // toPixel: where the point's projection onto the slice is seen.
  glm::dvec2 toPixel(const glm::dvec3& world) const;
  double millimetresPerPixel() const { return glm::length(right); }
};

// sliceFrame: the frame of a picture of `size` pixels; the slice of `geometry` is in its middle.
SliceFrame sliceFrame(const Geometry& geometry, const SliceCamera& camera, glm::ivec2 size);

}  // namespace sonoskin
