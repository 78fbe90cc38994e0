#include "render/oblique_plane.h"

#include <cmath>

#include "render/gl/read_pixels.h"
#include "render/slice_view.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {
namespace {

Geometry turned() {
  Geometry g;
  g.dims = {40, 30, 20};
  g.spacing = {0.5, 0.8, 1.7};
  g.origin = {5, -6, 7};
  const double c = std::cos(0.3), s = std::sin(0.3);
  g.direction = glm::dmat3(glm::dvec3(c, s, 0), glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1));
  return g;
}

void expectNear(const PlaneDirections& a, const PlaneDirections& b, double tolerance) {
  EXPECT_LT(glm::distance(a.right, b.right), tolerance);
  EXPECT_LT(glm::distance(a.down, b.down), tolerance);
}

TEST(ObliquePlane, AnglesAndDirectionsAreInverse) {
  const PlaneDirections base = directionsOf(turned(), SliceAxes{.right = 2, .down = 1, .rightGrows = false});
  for (const double tilt : {-170.0, -30.0, 0.0, 75.0, 180.0})
    for (const double turn : {-89.0, -20.0, 0.0, 45.0})
      for (const double roll : {-100.0, 0.0, 12.0}) {
        const PlaneDirections plane = directionsAt({tilt, turn, roll}, base);
        EXPECT_NEAR(glm::dot(plane.right, plane.down), 0, 1e-12);
        const ObliqueAngles angles = anglesOf(plane, base);
        EXPECT_NEAR(angles.turn, turn, 1e-6);
        EXPECT_NEAR(std::cos(glm::radians(angles.tilt - tilt)), 1, 1e-9);
        EXPECT_NEAR(angles.roll, roll, 1e-6);
      }
  for (const double turn : {-90.0, 90.0}) {
    const PlaneDirections plane = directionsAt({25, turn, 40}, base);
    expectNear(directionsAt(anglesOf(plane, base), base), plane, 1e-6);
  }
}

TEST(ObliquePlane, TurnsFromTheRightTowardWhatRunsDownward) {
  const PlaneDirections plane{{1, 0, 0}, {0, 1, 0}};
  expectNear(turnedAbout(plane, plane.normal(), glm::radians(90.0)), {{0, 1, 0}, {-1, 0, 0}}, 1e-12);
  PlaneDirections many = plane;
  for (int n = 0; n < 3600; ++n)
    many = turnedAbout(many, glm::normalize(glm::dvec3(1, 2, 3)), glm::radians(0.1));
  expectNear(many, plane, 1e-9);
}

TEST(ObliquePlane, GoesThroughTheCrossHairInMillimetresWhereverItIsMoved) {
  const Geometry g = turned();
  SliceCamera camera{.cursor = g.toWorld({11, 12, 13})};
  camera.oblique = directionsAt({33, -21, 70}, {});
  const SliceFrame frame = sliceFrame(g, camera, {300, 200});
  const glm::dvec3 n = camera.oblique->normal();
  EXPECT_NEAR(glm::dot(frame.toWorld({17, 180}) - camera.cursor, n), 0, 1e-9);
  EXPECT_NEAR(glm::distance(frame.toWorld({10, 10}), frame.toWorld({110, 10})),
              100 * frame.millimetresPerPixel(), 1e-9);
  EXPECT_NEAR(frame.millimetresPerPixel(), 34.0 / 200, 1e-9) << "the longest side, 20 voxels of 1.7 mm, fits";
  const glm::dvec2 before = frame.toPixel(camera.cursor);
  camera.cursor = frame.toWorld({250, 20});
  const SliceFrame after = sliceFrame(g, camera, {300, 200});
  EXPECT_LT(glm::distance(after.corner, frame.corner), 1e-9)
      << "the picture stays while the cross-hair moves in it";
  EXPECT_NEAR(glm::distance(after.toPixel(camera.cursor), glm::dvec2(250, 20)), 0, 1e-9);
  EXPECT_GT(glm::distance(before, glm::dvec2(250, 20)), 10);
}

class ObliqueSlice : public GlTest {};

// Trilinear interpolation has no error where values are linear in space, whatever spacing and directions are: every pixel of
// any plane shows its own place's value.
TEST_F(ObliqueSlice, ReproducesALinearFieldExactly) {
  const Geometry g = turned();
  const glm::dvec3 slope(0.013, -0.009, 0.011);
  const glm::dvec3 middle = g.toWorld(0.5 * glm::dvec3(g.dims - 1));
  const auto field = [&](const glm::dvec3& world) { return 0.5 + glm::dot(slope, world - middle); };
  auto volume = std::make_shared<Volume<float>>(g);
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) volume->at(i, j, k) = float(field(g.toWorld({i, j, k})));
  GpuVolume copy;
  copy.set(volume);
  constexpr glm::ivec2 kSize(90, 70);
  for (const ObliqueAngles& angles :
       {ObliqueAngles{30, 0, 0}, ObliqueAngles{-50, 35, 20}, ObliqueAngles{10, -80, 170}}) {
    SliceCamera camera{.cursor = g.toWorld({22.3, 11.6, 8.2}), .zoom = 1.4};
    camera.oblique = directionsAt(angles, {});
    const gl::Framebuffer target({.size = kSize});
    SliceView().draw({.frame = g, .camera = camera, .volume = copy}, target);
    const Image image = gl::readImage(target);
    const SliceFrame frame = sliceFrame(g, camera, kSize);
    double worst = 0;
    int inside = 0;
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        const glm::dvec3 world = frame.toWorld({x + 0.5, y + 0.5}), index = g.toIndex(world);
        if (glm::any(glm::lessThan(index, glm::dvec3(0))) ||
            glm::any(glm::greaterThan(index, glm::dvec3(g.dims - 1))))
          continue;
        ++inside;
        worst =
            std::max(worst, std::abs(image.rgba[std::size_t(4 * (y * kSize.x + x))] - 255 * field(world)));
      }
    EXPECT_GT(inside, 300);
    EXPECT_LT(worst, 0.75) << "half a step of the screen's 255, and a little for the texture's own steps";
  }
}

}  // namespace
}  // namespace sonoskin
