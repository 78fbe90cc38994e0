#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>

#include "core/volume/scan.h"

namespace sonoskin {

// Plane: one of three planes that are perpendicular to each other. Named by the body; where a scan knows none they are the
// scanner's own:
//   sagittal  from left to right it is crossed      scanner: B, along the beam and in elevation
//   coronal   from the front to the back            scanner: C, of constant depth
//   axial     from the feet to the head             scanner: A, along the beam and the lateral axis
enum class Plane { sagittal, coronal, axial };
constexpr std::array<Plane, 3> kPlanes{Plane::axial, Plane::sagittal, Plane::coronal};

// SliceAxes: how the slices of a plane lie in a volume: which of its axes (0: i, 1: j, 2: k) is across the plane, which runs
// to the right in the picture and which downward; true where the index grows that way, and across toward S, A, L.
struct SliceAxes {
  int across = 2, right = 0, down = 1;
  bool acrossGrows = true, rightGrows = true, downGrows = true;
  friend bool operator==(const SliceAxes&, const SliceAxes&) = default;
};

// PlaneAxes: those of the three planes, by Plane; each is across another axis. At first those of a scanner whose beams run
// along j.
struct PlaneAxes {
  std::array<SliceAxes, 3> byPlane{{{.across = 0, .right = 2, .down = 1},
                                    {.across = 1, .right = 0, .down = 2},
                                    {.across = 2, .right = 0, .down = 1}}};

  const SliceAxes& operator[](Plane plane) const { return byPlane[std::size_t(plane)]; }
  // across: the plane whose slices are crossed by an axis of the volume.
  Plane across(int axis) const;
  friend bool operator==(const PlaneAxes&, const PlaneAxes&) = default;
};

// ViewFrame: the directions that slices and the 3D view keep to. World, unit.
//   isPatient   to the patient's left, back and head; else the scanner's: lateral, along the beam, elevation
//   directions  columns, orthogonal; may mirror
//   forward     where the 3D view looks at first; of a scanner's the beam, away from the probe
//   up          what it shows upward
//   turn        how a person has turned what is seen: its columns, in the frame, take the place of the frame's directions;
//               a rotation by multiples of 90 degrees
struct ViewFrame {
  bool isPatient = false;
  glm::dmat3 directions{1};
  glm::dvec3 forward{0, 1, 0}, up{1, 0, 0};
  glm::dmat3 turn{1};

  // turned: where a direction of the world that is looked along is to be taken instead, for what is seen is turned.
  glm::dvec3 turned(const glm::dvec3& direction) const {
    return directions * (turn * (glm::transpose(directions) * direction));
  }
};

// patientFrame: that of the world, LPS; the 3D view looks from the front, with the head up.
ViewFrame patientFrame();
// scannerFrame: that of the beam, by the axes of the volume that are nearest to it; index grows in lateral and elevation.
ViewFrame scannerFrame(const Geometry& geometry, const Beam& beam);

// planeAxes: the planes as a frame has them, by the axes of the volume that are nearest to its directions. Patient: as
// radiologists look at them (axial from the feet, coronal from the front, both with the patient's right on the left;
// sagittal with the front on the left, as 3D Slicer). Scanner: depth downward in A and B; C with elevation downward.
PlaneAxes planeAxes(const Geometry& geometry, const ViewFrame& frame);

// isQuarterTurn: whether a matrix turns by quarters about the axes, and does nothing else.
bool isQuarterTurn(const glm::dmat3& turn);

// turnedInPlane: the frame's turn after what a plane's picture shows was turned clockwise by a quarter, in all views.
glm::dmat3 turnedInPlane(const ViewFrame& frame, Plane plane);

// edgeText: what lies in a direction of the world: R, L, A, P, S or I, two of them where it lies between; of a scanner's
// frame "probe" or "top", and nothing in other directions.
std::string edgeText(const ViewFrame& frame, const glm::dvec3& direction);

// planeName: "Axial", or "A" in a scanner's frame.
const char* planeName(const ViewFrame& frame, Plane plane);

// planeColour: sRGB, 0 to 1: axial red, sagittal yellow, coronal green.
glm::vec3 planeColour(Plane plane);

}  // namespace sonoskin
