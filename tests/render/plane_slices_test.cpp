#include "render/plane_slices.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/gl/read_pixels.h"
#include "render/slice_view.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {
namespace {

// Noise of more than 8 bits on a turned grid of unequal spacing.
std::shared_ptr<const Volume<float>> noise() {
  Geometry g;
  g.dims = {23, 14, 9};
  g.spacing = {0.5, 0.8, 1.1};
  const double c = std::cos(0.7), s = std::sin(0.7);
  g.direction = glm::dmat3(glm::dvec3(c, s, 0), glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1));
  g.origin = {-20, 31, 7};
  auto volume = std::make_shared<Volume<float>>(g);
  unsigned state = 3;
  for (float& v : volume->data) v = float((state = state * 1664525u + 1013904223u) >> 8) / float(1 << 24);
  return volume;
}

TEST(PlaneSlices, AreOneOrTwoAndStayWhereTheyAre) {
  const auto volume = noise();
  const Geometry& g = volume->geometry;
  for (const Plane plane : kPlanes)
    for (const double at : {-4.0, 0.0, 2.3, 7.9, 8.0, 40.0}) {
      glm::dvec3 index(3, 4, 5);
      index[PlaneAxes{}[plane].across] = at;
      const auto some = slicesAround(volume, PlaneAxes{}[plane].across, g.toWorld(index));
      const glm::ivec3 dims = some->geometry.dims;
      EXPECT_LE(dims[PlaneAxes{}[plane].across], 2);
      EXPECT_EQ(dims[PlaneAxes{}[plane].right], g.dims[PlaneAxes{}[plane].right]);
      for (int k = 0; k < dims.z; ++k)
        for (int j = 0; j < dims.y; ++j)
          for (int i = 0; i < dims.x; ++i) {
            const glm::ivec3 in(glm::round(g.toIndex(some->geometry.toWorld(glm::dvec3(i, j, k)))));
            ASSERT_EQ(some->at(i, j, k), volume->at(in.x, in.y, in.z));
          }
    }
  EXPECT_EQ(slicesAround(std::shared_ptr<const Volume<float>>(), 2, {}), nullptr);
}

class PlaneSlicesTest : public GlTest {};

// The picture of some slices is the one of the whole volume, between its slices, at its sides and beyond them.
TEST_F(PlaneSlicesTest, ShowWhatTheWholeVolumeShows) {
  const auto volume = noise();
  const Geometry& g = volume->geometry;
  SliceView view;
  for (const Plane plane : kPlanes)
    for (const double at : {-2.0, -0.4, 0.0, 3.37, 7.5, 8.4, 8.6}) {
      glm::dvec3 index(3, 4, 5);
      index[PlaneAxes{}[plane].across] = at;
      const SliceCamera camera{.plane = plane, .cursor = g.toWorld(index)};
      const auto picture = [&](std::shared_ptr<const Volume<float>> shown) {
        GpuVolume copy;
        copy.set(std::move(shown));
        const gl::Framebuffer target({.size = {60, 50}});
        view.draw({.frame = g, .camera = camera, .volume = copy}, target);
        return gl::readImage(target);
      };
      const Image whole = picture(volume),
                  some = picture(slicesAround(volume, PlaneAxes{}[plane].across, camera.cursor));
      int worst = 0;
      for (std::size_t i = 0; i < whole.rgba.size(); ++i)
        worst = std::max(worst, std::abs(int(whole.rgba[i]) - int(some.rgba[i])));
      EXPECT_LE(worst, 1) << planeColour(plane).r << " at " << at;
    }
}

}  // namespace
}  // namespace sonoskin
