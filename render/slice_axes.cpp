#include "render/slice_axes.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

// NearAxis: an axis of the volume near a direction of the frame; whether its index grows that way.
struct NearAxis {
  int axis = 0;
  bool grows = true;
};
using NearAxes = std::array<NearAxis, 3>;

// The axes that are nearest to the three directions together, each taken once.
NearAxes nearestAxes(const Geometry& geometry, const glm::dmat3& directions) {
  const glm::dmat3 cosines = glm::transpose(geometry.direction) * directions;  // [direction][axis]
  std::array<int, 3> order{0, 1, 2}, best = order;
  double most = -1;
  do {
    double sum = 0;
    for (int n = 0; n < 3; ++n) sum += std::abs(cosines[n][order[std::size_t(n)]]);
    if (sum > most + 1e-9) most = sum, best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  NearAxes near;
  for (int n = 0; n < 3; ++n) {
    const int axis = best[std::size_t(n)];
    near[std::size_t(n)] = {axis, cosines[n][axis] >= 0};
  }
  return near;
}

// Layout: how the picture across a direction of the frame lies: which direction runs to the right, and which downward, or
// upward.
struct Layout {
  int right, down;
  bool downward = true;
};

Layout layoutAcross(const ViewFrame& frame, int direction) {
  constexpr std::array<Layout, 3> kPatient{{{1, 2, false}, {0, 2, false}, {0, 1, true}}};
  constexpr std::array<Layout, 3> kScanner{{{2, 1, true}, {0, 2, true}, {0, 1, true}}};
  return (frame.isPatient ? kPatient : kScanner)[std::size_t(direction)];
}

// The direction of the turned frame that is a plane's across; planes are counted as the frame's directions are.
int acrossIn(const ViewFrame& frame, Plane plane) {
  int found = 0;
  for (int m = 0; m < 3; ++m)
    if (std::abs(frame.turn[m][int(plane)]) > 0.5) found = m;
  return found;
}

char letterOf(int axis, bool positive) { return "RLAPIS"[2 * axis + (positive ? 1 : 0)]; }

}  // namespace

Plane PlaneAxes::across(int axis) const {
  return *std::ranges::find_if(kPlanes, [&](Plane plane) { return (*this)[plane].across == axis; });
}

ViewFrame patientFrame() {
  return {.isPatient = true, .directions = glm::dmat3(1), .forward = {0, 1, 0}, .up = {0, 0, 1}};
}

ViewFrame scannerFrame(const Geometry& geometry, const Beam& beam) {
  const glm::dmat3 given(beam.up, beam.axis, glm::cross(beam.up, beam.axis));
  const NearAxes near = nearestAxes(geometry, given);
  ViewFrame frame;
  for (int n = 0; n < 3; ++n) {
    const NearAxis& axis = near[std::size_t(n)];
    frame.directions[n] = (n == 1 && !axis.grows ? -1.0 : 1.0) * geometry.direction[axis.axis];
  }
  frame.forward = beam.axis;
  frame.up = beam.up;
  return frame;
}

PlaneAxes planeAxes(const Geometry& geometry, const ViewFrame& frame) {
  const NearAxes turned = nearestAxes(geometry, frame.directions * frame.turn);
  const NearAxes still = nearestAxes(geometry, frame.directions);
  PlaneAxes planes;
  for (const Plane plane : kPlanes) {
    const Layout layout = layoutAcross(frame, acrossIn(frame, plane));
    const NearAxis &right = turned[std::size_t(layout.right)], &down = turned[std::size_t(layout.down)];
    const NearAxis& across = still[std::size_t(plane)];
    // Toward the front, where the patient's direction is to the back.
    const bool backward = frame.isPatient && plane == Plane::coronal;
    planes.byPlane[std::size_t(plane)] = {across.axis, right.axis,
                                          down.axis,   across.grows != backward,
                                          right.grows, down.grows == layout.downward};
  }
  return planes;
}

bool isQuarterTurn(const glm::dmat3& turn) {
  glm::dmat3 whole;
  for (int n = 0; n < 3; ++n) whole[n] = glm::round(turn[n]);
  return whole == turn && glm::transpose(turn) * turn == glm::dmat3(1) && glm::determinant(turn) > 0;
}

glm::dmat3 turnedInPlane(const ViewFrame& frame, Plane plane) {
  const Layout layout = layoutAcross(frame, acrossIn(frame, plane));
  const double sign = layout.downward ? 1 : -1;
  glm::dmat3 turn = frame.turn;
  turn[layout.right] = -sign * frame.turn[layout.down];
  turn[layout.down] = sign * frame.turn[layout.right];
  return turn;
}

std::string edgeText(const ViewFrame& frame, const glm::dvec3& direction) {
  constexpr double kNear = 0.7, kAlso = 0.5;  // cosines
  if (!frame.isPatient) {
    if (glm::dot(direction, frame.forward) < -kNear) return "probe";
    return glm::dot(direction, frame.up) > kNear ? "top" : "";
  }
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
  std::string text(1, letterOf(order[0], direction[order[0]] > 0));
  if (std::abs(direction[order[1]]) > kAlso) text += letterOf(order[1], direction[order[1]] > 0);
  return text;
}

const char* planeName(const ViewFrame& frame, Plane plane) {
  constexpr std::array<const char*, 3> kPatient{"Sagittal", "Coronal", "Axial"}, kScanner{"B", "C", "A"};
  return (frame.isPatient ? kPatient : kScanner)[std::size_t(plane)];
}

glm::vec3 planeColour(Plane plane) {
  switch (plane) {
    case Plane::sagittal:
      return {0.94f, 0.87f, 0.36f};
    case Plane::coronal:
      return {0.12f, 0.68f, 0.53f};
    case Plane::axial:
      return {0.88f, 0.35f, 0.20f};
  }
  return {};
}

}  // namespace sonoskin
