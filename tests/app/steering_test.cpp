#include "app/views/steering.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sonoskin::ui {
namespace {

// Views of three sizes on a volume of three extents, all zoomed together.
class LinkedZoom : public testing::Test {
 protected:
  LinkedZoom() {
    geometry.dims = {467, 255, 124};
    geometry.spacing = {0.3, 0.4, 0.7};
    view.cursor = geometry.toWorld(0.5 * glm::dvec3(geometry.dims - 1));
    view.planes = planeAxes(geometry, scannerFrame(geometry, Beam{}));
    view.linkedZoom = true;
  }
  static PaneInput paneOf(Plane plane) {
    constexpr std::array<glm::vec2, 3> kSizes{{{300, 310}, {520, 200}, {410, 330}}};
    PaneInput pane;
    pane.size = kSizes[std::size_t(plane)];
    return pane;
  }
  double scaleOf(Plane plane) { return frameOf(view, plane, geometry, paneOf(plane)).millimetresPerPixel(); }
  void link() {
    for (const Plane plane : kPlanes) linkZoom(view, plane, geometry, paneOf(plane));
  }
  void zoom(Plane plane, float notches) {
    PaneInput pane = paneOf(plane);
    pane.mouse = {70, 110};
    pane.wheel = notches;
    pane.control = true;
    double turns = 0;
    view.pointedAt = plane;
    steerSlice(view, plane, geometry, turns, pane);
  }
  void expectTheSame(double scale) {
    for (const Plane plane : kPlanes) EXPECT_NEAR(scaleOf(plane), scale, 1e-9) << int(plane);
  }

  Geometry geometry;
  ViewState view;
};

TEST_F(LinkedZoom, GivesAllSlicesTheSameMillimetresPerPixel) {
  const double whole = scaleOf(Plane::axial);
  link();
  expectTheSame(whole);
  zoom(Plane::axial, 3);
  link();
  expectTheSame(whole / std::pow(1.15, 3));
  zoom(Plane::coronal, -1);
  zoom(Plane::coronal, 4);
  link();
  expectTheSame(whole / std::pow(1.15, 6));
}

TEST_F(LinkedZoom, LeavesAloneWhatIsSeenAloneAndGoesOnFromIt) {
  link();
  view.maximised = Pane::axial;
  zoom(Plane::axial, 2);
  const SlicePose pose = view.slices[std::size_t(Plane::axial)];
  link();
  EXPECT_EQ(view.slices[std::size_t(Plane::axial)].zoom, pose.zoom);
  view.maximised.reset();
  const double scale = scaleOf(Plane::axial);
  link();
  link();
  expectTheSame(scale);
}

}  // namespace
}  // namespace sonoskin::ui
