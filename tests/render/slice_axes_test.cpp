#include "render/slice_axes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/slice_frame.h"

namespace sonoskin {
namespace {

// All 48 ways in which the axes of a volume can lie along those of the world.
std::vector<glm::dmat3> everyDirection() {
  std::vector<glm::dmat3> all;
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      glm::dmat3 d(0);
      for (int n = 0; n < 3; ++n) d[n][order[std::size_t(n)]] = (signs >> n) & 1 ? -1 : 1;
      all.push_back(d);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return all;
}

Geometry geometryAlong(const glm::dmat3& direction) {
  Geometry g;
  g.dims = {20, 30, 40};
  g.spacing = {0.5, 0.7, 1.1};
  g.origin = {3, -8, 12};
  g.direction = direction;
  return g;
}

// Seen: what the edges of a plane's picture are directions of, by way of its pixels.
struct Seen {
  glm::dvec3 right, down;
  bool operator==(const Seen&) const = default;
};
Seen seen(const Geometry& g, const ViewFrame& frame, Plane plane) {
  const SliceCamera camera{.plane = plane, .cursor = g.toWorld({4, 5, 6}), .planes = planeAxes(g, frame)};
  const SliceFrame f = sliceFrame(g, camera, {300, 200});
  return {glm::normalize(f.toWorld({101, 50}) - f.toWorld({100, 50})),
          glm::normalize(f.toWorld({100, 51}) - f.toWorld({100, 50}))};
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) { EXPECT_LT(glm::distance(a, b), 1e-9); }

constexpr glm::dvec3 kLeft{1, 0, 0}, kBack{0, 1, 0}, kHead{0, 0, 1};

TEST(SliceAxes, AllWaysToStoreAPatientLookTheSame) {
  const ViewFrame frame = patientFrame();
  ASSERT_EQ(everyDirection().size(), 48u);
  for (const glm::dmat3& direction : everyDirection()) {
    const Geometry g = geometryAlong(direction);
    const Seen axial = seen(g, frame, Plane::axial), coronal = seen(g, frame, Plane::coronal),
               sagittal = seen(g, frame, Plane::sagittal);
    expectNear(axial.right, kLeft);
    expectNear(axial.down, kBack);
    expectNear(coronal.right, kLeft);
    expectNear(coronal.down, -kHead);
    expectNear(sagittal.right, kBack);
    expectNear(sagittal.down, -kHead);
    // The next slice is one toward the left, the front and the head.
    const std::array<glm::dvec3, 3> next{kLeft, -kBack, kHead};
    const PlaneAxes planes = planeAxes(g, frame);
    for (const Plane plane : kPlanes) {
      const SliceAxes& axes = planes[plane];
      expectNear((axes.acrossGrows ? 1.0 : -1.0) * direction[axes.across], next[std::size_t(plane)]);
      EXPECT_EQ(planes.across(axes.across), plane);
      EXPECT_EQ(axes.across + axes.right + axes.down, 3) << "every axis once";
    }
  }
}

// A scan that lies obliquely keeps to the planes that are nearest.
TEST(SliceAxes, ObliqueVolumesKeepTheNearestAxes) {
  const double c = std::cos(0.5), s = std::sin(0.5);
  const glm::dmat3 tilt(glm::dvec3(1, 0, 0), glm::dvec3(0, c, s), glm::dvec3(0, -s, c));
  for (const glm::dmat3& direction : everyDirection()) {
    const Seen coronal = seen(geometryAlong(tilt * direction), patientFrame(), Plane::coronal);
    expectNear(coronal.right, kLeft);
    expectNear(coronal.down, tilt * -kHead);
  }
  EXPECT_EQ(edgeText(patientFrame(), tilt * kHead), "S");
  EXPECT_EQ(edgeText(patientFrame(), glm::normalize(glm::dvec3(0, 0.8, 1))), "SP");
}

TEST(SliceAxes, LettersNameTheEdges) {
  const ViewFrame frame = patientFrame();
  EXPECT_EQ(edgeText(frame, -kLeft), "R");
  EXPECT_EQ(edgeText(frame, kLeft), "L");
  EXPECT_EQ(edgeText(frame, -kBack), "A");
  EXPECT_EQ(edgeText(frame, kBack), "P");
  EXPECT_EQ(edgeText(frame, -kHead), "I");
  EXPECT_EQ(edgeText(frame, kHead), "S");
}

// Whatever the axis that the beams run along: depth is downward, and what is above is the probe.
TEST(SliceAxes, AScannersPlanesFollowItsBeam) {
  for (const glm::dmat3& direction : everyDirection())
    for (const glm::dmat3& beams : everyDirection()) {
      const Geometry g = geometryAlong(direction);
      const Beam beam{.apex = {}, .axis = beams[0], .up = beams[1]};
      const ViewFrame frame = scannerFrame(g, beam);
      const Seen a = seen(g, frame, Plane::axial), b = seen(g, frame, Plane::sagittal),
                 c = seen(g, frame, Plane::coronal);
      expectNear(a.down, beam.axis);
      expectNear(b.down, beam.axis);
      EXPECT_NEAR(std::abs(glm::dot(a.right, beam.up)), 1, 1e-9) << "A: the lateral axis";
      EXPECT_NEAR(std::abs(glm::dot(b.right, glm::cross(beam.axis, beam.up))), 1, 1e-9) << "B: elevation";
      EXPECT_NEAR(glm::dot(c.right, beam.axis), 0, 1e-9) << "C: constant depth";
      EXPECT_NEAR(glm::dot(c.down, beam.axis), 0, 1e-9);
      EXPECT_EQ(edgeText(frame, -a.down), "probe");
      EXPECT_EQ(edgeText(frame, beam.up), "top");
      EXPECT_EQ(edgeText(frame, a.down), "");
    }
}

// As most scans are stored, and as they were shown from the beginning: no axis is turned over.
TEST(SliceAxes, BeamsAlongJShowTheIndicesAsTheyGrow) {
  const Geometry g = geometryAlong(glm::dmat3(1));
  const ViewFrame frame = scannerFrame(g, {.apex = {}, .axis = {0, 1, 0}, .up = {-1, 0, 0}});
  EXPECT_EQ(planeAxes(g, frame), PlaneAxes{});
}

TEST(SliceAxes, AQuarterTurnIsClockwiseInItsPlaneAndFourAreNone) {
  for (const glm::dmat3& direction : everyDirection())
    for (const Plane plane : kPlanes)
      for (const bool patient : {true, false}) {
        const Geometry g = geometryAlong(direction);
        ViewFrame frame = patient ? patientFrame() : scannerFrame(g, {});
        const ViewFrame first = frame;
        const PlaneAxes before = planeAxes(g, frame);
        const Seen still = seen(g, frame, plane);
        frame.turn = turnedInPlane(frame, plane);
        const Seen turned = seen(g, frame, plane);
        expectNear(turned.right, -still.down);  // what was on top is on the right
        expectNear(turned.down, still.right);
        EXPECT_TRUE(isQuarterTurn(frame.turn));
        EXPECT_EQ(planeAxes(g, frame)[plane].across, before[plane].across);
        for (int n = 0; n < 3; ++n) frame.turn = turnedInPlane(frame, plane);
        EXPECT_EQ(frame.turn, first.turn);
        EXPECT_EQ(planeAxes(g, frame), before);
      }
}

TEST(SliceAxes, OnlyRotationsByQuartersAreTurns) {
  EXPECT_TRUE(isQuarterTurn(glm::dmat3(1)));
  EXPECT_FALSE(isQuarterTurn(glm::dmat3(-1))) << "a mirror";
  EXPECT_FALSE(isQuarterTurn(glm::dmat3(2)));
  const double c = std::cos(0.3), s = std::sin(0.3);
  EXPECT_FALSE(isQuarterTurn(glm::dmat3(glm::dvec3(c, s, 0), glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1))));
}

}  // namespace
}  // namespace sonoskin
