#include "render/slice_frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin {
namespace {

Geometry turned() {
  Geometry g;
  g.dims = {40, 30, 20};
  g.spacing = {0.5, 1, 2};
  g.origin = {5, -6, 7};
  const double c = std::cos(0.3), s = std::sin(0.3);
  g.direction = glm::dmat3(glm::dvec3(c, s, 0), glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1));
  return g;
}

TEST(SliceFrame, PixelsAndWorldAreInverse) {
  const Geometry g = turned();
  for (const Plane plane : kPlanes) {
    const SliceCamera camera{plane, g.toWorld({11, 12, 13}), {3, -4}, 1.7};
    const SliceFrame frame = sliceFrame(g, camera, {300, 200});
    const glm::dvec2 pixel = frame.toPixel(frame.toWorld({17.5, 90.25}));
    EXPECT_NEAR(pixel.x, 17.5, 1e-9);
    EXPECT_NEAR(pixel.y, 90.25, 1e-9);
    // Every pixel lies in the slice of the cursor.
    EXPECT_NEAR(g.toIndex(frame.toWorld({17, 5}))[camera.axes().across], 11 + camera.axes().across, 1e-9);
    EXPECT_NEAR(glm::length(frame.right), glm::length(frame.down), 1e-12);
  }
}

TEST(SliceFrame, WholeSliceJustFitsAndIsInTheMiddle) {
  const Geometry g = turned();
  // 20 mm x 30 mm in 400 x 200 pixels: the height decides.
  const SliceFrame frame = sliceFrame(g, {.plane = Plane::axial, .cursor = g.toWorld({0, 0, 5})}, {400, 200});
  EXPECT_NEAR(frame.millimetresPerPixel(), 0.15, 1e-12);
  const glm::dvec2 first = frame.toPixel(g.toWorld({-0.5, -0.5, 5})),
                   last = frame.toPixel(g.toWorld({39.5, 29.5, 5}));
  EXPECT_NEAR(first.y, 0, 1e-9);
  EXPECT_NEAR(last.y, 200, 1e-9);
  EXPECT_NEAR(first.x + last.x, 400, 1e-9);
}

TEST(SliceFrame, PanMovesThePictureByMillimetres) {
  const Geometry g = turned();
  const glm::dvec3 p = g.toWorld({10, 10, 5});
  SliceCamera camera{.plane = Plane::axial, .cursor = p};
  const glm::dvec2 before = sliceFrame(g, camera, {400, 200}).toPixel(p);
  camera.pan = {1.5, -3};
  const glm::dvec2 after = sliceFrame(g, camera, {400, 200}).toPixel(p);
  EXPECT_NEAR(after.x - before.x, 10, 1e-9);
  EXPECT_NEAR(after.y - before.y, -20, 1e-9);
}

}  // namespace
}  // namespace sonoskin
