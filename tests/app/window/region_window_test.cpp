#include "app/document/crop_box.h"
#include "render/gl/context.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

// Where a place in the world is seen in the axial slice, on the screen.
ImVec2 inAxial(Driver& d, const glm::dvec3& world) {
  const ImVec2 corner = d.point("pane.axial", 0, 0), end = d.point("pane.axial", 1, 1);
  const ViewState& view = d.workspace().view;
  const SlicePose& pose = view.slices[std::size_t(Plane::axial)];
  const SliceFrame frame =
      sliceFrame(d.session().scan().volume->geometry, {Plane::axial, view.cursor, pose.pan, pose.zoom},
                 glm::ivec2(int(end.x - corner.x), int(end.y - corner.y)));
  const glm::dvec2 pixel = frame.toPixel(world);
  return {corner.x + float(pixel.x), corner.y + float(pixel.y)};
}

// The surface point in the middle of the axial slice that is shown.
glm::dvec3 surfaceInSlice(Driver& d) {
  const Geometry& g = d.session().scan().volume->geometry;
  const glm::dvec3 cursor = g.toIndex(d.workspace().view.cursor);
  glm::dvec3 best = cursor;
  double least = 1e9;
  for (const glm::vec3& p : d.session().results().points->positions) {
    const glm::dvec3 index = g.toIndex(glm::dvec3(p));
    const double away = std::abs(index.x - cursor.x);
    if (std::abs(index.z - cursor.z) < 0.6 && away < least) {
      least = away;
      best = index;
    }
  }
  return g.toWorld({best.x, best.y, cursor.z});
}

TEST_F(WindowTest, DragsTheCropBox) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  const Geometry& g = d.session().scan().volume->geometry;
  const std::size_t before = d.session().results().points->size();
  const auto region = [&]() -> const RegionOptions& { return d.session().parameters().region; };
  const glm::dvec3 cursor = d.workspace().view.cursor;

  // The right side of the box in the axial slice is the high end of i.
  const double length = g.spacing.x * (g.dims.x - 1);
  glm::dvec3 from = cursor, to = cursor;
  from.x = g.toWorld(glm::dvec3(g.dims) - 0.5).x;
  to.x = from.x - 0.4 * length;
  from.y = to.y = g.toWorld(0.75 * glm::dvec3(g.dims)).y;
  d.drag(inAxial(d, from), inAxial(d, to));
  EXPECT_NEAR(region().cutHigh[0], 0.4 * length, 0.03 * length);
  EXPECT_EQ(region().cutLow, (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(d.workspace().view.cursor, cursor) << "the cross-hair stays";
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_LT(d.session().results().points->size(), before);
  EXPECT_GT(d.session().results().points->size(), before / 4);
  for (const glm::vec3& p : d.session().results().points->positions)
    ASSERT_LT(p.x, length - region().cutHigh[0] + 1);

  // Undo and redo, as of every parameter.
  d.press("ctrl+z");
  EXPECT_EQ(region().cutHigh[0], 0);
  d.press("ctrl+shift+z");
  EXPECT_GT(region().cutHigh[0], 0);

  // The same from the side panel.
  d.openStep(Step::region);
  d.drag(d.point("region.j.low", 0.03f), d.point("region.j.low", 0.3f));
  EXPECT_GT(region().cutLow[1], 5);
  d.moveTo({5, 5});
  d.screenshot("sonoskin_crop_box");
  d.click("region.resetBox");
  EXPECT_EQ(region().cutLow[1], 0);
  EXPECT_EQ(region().cutHigh[0], 0);
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_EQ(d.session().results().points->size(), before);
  EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError();
}

TEST_F(WindowTest, ErasesAStroke) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  const Geometry& g = d.session().scan().volume->geometry;
  const auto before = d.session().results().points;
  const glm::dvec3 cursor = d.workspace().view.cursor, middle = surfaceInSlice(d);
  const Image plain = d.screenshot("sonoskin_not_erased");

  d.press("e");
  ASSERT_EQ(d.workspace().view.sliceTool, Tool::eraser);
  const double radius = d.workspace().view.brushRadius;
  d.press("bracketright");
  EXPECT_GT(d.workspace().view.brushRadius, radius);
  d.press("bracketleft");
  EXPECT_NEAR(d.workspace().view.brushRadius, radius, 1e-9);

  const glm::dvec3 a = middle - glm::dvec3(4, 0, 0), b = middle + glm::dvec3(4, 0, 0);
  d.drag(inAxial(d, a), inAxial(d, b));
  EXPECT_EQ(d.workspace().view.cursor, cursor);
  ASSERT_TRUE(d.waitUntilIdle());
  // Every place within the radius of the stroke is gone, off the slice as well; the mouse is as fine as a pixel.
  const ErasedParts& erased = d.session().erased();
  ASSERT_GT(erased.voxels(), 100u);
  for (const glm::dvec3& off : {glm::dvec3(0, 0, 0), glm::dvec3(0, 0, radius - 1), glm::dvec3(0, 4, 0)}) {
    const glm::ivec3 v(glm::round(g.toIndex(middle + off)));
    EXPECT_TRUE(erased.mask().at(v.x, v.y, v.z)) << off.x << " " << off.y << " " << off.z;
  }
  for (const glm::vec3& p : d.session().results().points->positions)
    ASSERT_GT(glm::distance(glm::dvec3(p), middle), radius - 2.5);  // the points were moved onto the skin
  d.moveTo({5, 5});
  const auto isRed = [](Colour c) { return c.r > c.g + 25 && c.r > c.b + 10; };
  const Image tinted = d.screenshot("sonoskin_erased");
  EXPECT_GT(share(tinted, d, "pane.axial", isRed), share(plain, d, "pane.axial", isRed) + 0.005);

  const std::size_t voxels = erased.voxels();
  d.mouse("keydown ctrl");
  d.drag(inAxial(d, middle), inAxial(d, b));
  d.mouse("keyup ctrl");
  EXPECT_LT(erased.voxels(), voxels) << "Ctrl brings back";
  d.press("ctrl+z");
  EXPECT_EQ(erased.voxels(), voxels);
  d.press("ctrl+z");
  EXPECT_EQ(erased.voxels(), 0u);
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_EQ(d.session().results().points->positions, before->positions);
  d.press("Escape");
  EXPECT_EQ(d.workspace().view.sliceTool, Tool::crossHair);
  EXPECT_TRUE(d.workspace().toasts.list.empty()) << d.workspace().toasts.list.front().text;
  EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError();
}

}  // namespace
}  // namespace sonoskin
