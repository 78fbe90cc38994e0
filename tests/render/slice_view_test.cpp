#include "render/slice_view.h"

#include <gtest/gtest.h>

#include "render/gl/read_pixels.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {
namespace {

class SliceViewTest : public GlTest {
 protected:
  static Geometry geometry() {
    Geometry g;
    g.dims = {24, 16, 8};
    g.origin = {100, 50, -20};
    return g;
  }
  static std::uint8_t byteAt(int i, int j, int k) { return std::uint8_t((i * 10 + j * 7 + k * 29) % 256); }
  static Volume<float> numbered() {
    Volume<float> volume(geometry());
    for (int k = 0; k < 8; ++k)
      for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 24; ++i) volume.at(i, j, k) = float(byteAt(i, j, k)) / 255.0f;
    return volume;
  }
  static glm::ivec3 pixel(const Image& image, int x, int y) {
    const std::uint8_t* p = &image.rgba[std::size_t(4 * (y * image.width + x))];
    return {p[0], p[1], p[2]};
  }
  Image draw(const SliceViewInput& input, glm::ivec2 size) {
    const gl::Framebuffer target({.size = size});
    SliceView().draw(input, target);
    return gl::readImage(target);
  }
};

TEST_F(SliceViewTest, OnePixelPerVoxelShowsTheVoxelsExactly) {
  GpuVolume volume;
  volume.set(std::make_shared<Volume<float>>(numbered()));
  const Geometry g = geometry();
  for (const Plane plane : kPlanes) {
    const SliceCamera camera{.plane = plane, .cursor = g.toWorld({9, 6, 3})};
    const glm::ivec2 size(g.dims[camera.axes().right], g.dims[camera.axes().down]);
    const Image image = draw({.frame = g, .camera = camera, .volume = volume, .crossHair = false}, size);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        glm::ivec3 index(9, 6, 3);
        index[camera.axes().right] = x;
        index[camera.axes().down] = y;
        const int expected = byteAt(index.x, index.y, index.z);
        ASSERT_NEAR(pixel(image, x, y).r, expected, 1) << x << " " << y << " " << int(plane);
        ASSERT_EQ(pixel(image, x, y).r, pixel(image, x, y).b);
      }
  }
}

TEST_F(SliceViewTest, WindowAndLevelStretchTheValues) {
  GpuVolume volume;
  volume.set(std::make_shared<Volume<float>>(Volume<float>(geometry(), 0.4f)));
  const SliceCamera camera{.cursor = geometry().toWorld({9, 6, 3})};
  const auto shown = [&](GreyWindow window) {
    const Geometry g = geometry();
    SliceViewInput in{.frame = g, .camera = camera, .volume = volume, .window = window, .crossHair = false};
    return pixel(draw(in, {24, 16}), 12, 8).r;
  };
  EXPECT_NEAR(shown({0.5f, 1}), 102, 1);
  EXPECT_NEAR(shown({0.4f, 0.2f}), 128, 1);
  EXPECT_EQ(shown({0.2f, 0.2f}), 255);
  EXPECT_EQ(shown({0.8f, 0.2f}), 0);
}

TEST_F(SliceViewTest, CoarseOverlayLiesWhereItIsInTheWorld) {
  GpuVolume volume, overlay;
  volume.set(std::make_shared<Volume<float>>(Volume<float>(geometry(), 0.0f)));
  // Half the resolution; its voxel (3, 5, 2) has its centre between the fine voxels 6 and 7, 10 and 11, 4 and 5.
  Geometry coarse = geometry();
  coarse.dims = coarse.dims / 2;
  coarse.spacing = glm::dvec3(2);
  coarse.origin = geometry().toWorld(glm::dvec3(0.5));
  Volume<std::uint8_t> mark(coarse);
  mark.at(3, 5, 2) = 255;
  overlay.set(std::make_shared<Volume<std::uint8_t>>(mark));
  const Geometry g = geometry();
  const SliceCamera camera{.plane = Plane::axial, .cursor = g.toWorld({0, 0, 4.5})};
  const Image image = draw({.frame = g,
                            .camera = camera,
                            .volume = volume,
                            .overlay = &overlay,
                            .overlayColour = {1, 0, 0},
                            .crossHair = false},
                           {24, 16});
  glm::dvec3 sum(0);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x) sum += double(pixel(image, x, y).r) * glm::dvec3(x, y, 1);
  EXPECT_NEAR(sum.x / sum.z, 6.5, 0.05);
  EXPECT_NEAR(sum.y / sum.z, 10.5, 0.05);
  EXPECT_EQ(pixel(image, 6, 10).g, 0);
}

// Both lie over the grey, and the overlay over the tint.
TEST_F(SliceViewTest, ATintLiesBelowTheOverlay) {
  GpuVolume volume, tint, overlay;
  volume.set(std::make_shared<Volume<float>>(Volume<float>(geometry(), 0.4f)));
  Volume<float> some(geometry());
  some.at(5, 5, 3) = some.at(6, 5, 3) = 1;
  tint.set(std::make_shared<Volume<float>>(some));
  Volume<std::uint8_t> one(geometry());
  one.at(6, 5, 3) = 255;
  overlay.set(std::make_shared<Volume<std::uint8_t>>(one));
  const Geometry g = geometry();
  const SliceCamera camera{.plane = Plane::axial, .cursor = g.toWorld({0, 0, 3})};
  SliceViewInput input{.frame = g, .camera = camera, .volume = volume, .overlay = &overlay};
  input.overlayColour = {1, 0, 0};
  input.crossHair = false;
  input.tint = &tint;
  input.tintColour = {0, 0, 1};
  input.tintOpacity = 1;
  const Image image = draw(input, {24, 16});
  EXPECT_EQ(pixel(image, 5, 5), glm::ivec3(0, 0, 255));
  EXPECT_EQ(pixel(image, 6, 5), glm::ivec3(255, 0, 0));
  EXPECT_EQ(pixel(image, 9, 5), glm::ivec3(102));
}

TEST_F(SliceViewTest, ErasedVoxelsAreTintedAndOthersAreNot) {
  GpuVolume volume;
  volume.set(std::make_shared<Volume<float>>(Volume<float>(geometry(), 0.4f)));
  const Geometry g = geometry();
  Volume<std::uint8_t> mask(g);
  mask.at(7, 5, 3) = mask.at(8, 5, 3) = mask.at(7, 9, 4) = 1;
  GpuMask erased;
  erased.set(mask, Hasher("first").key());
  const SliceCamera camera{.plane = Plane::axial, .cursor = g.toWorld({0, 0, 3})};
  SliceViewInput input{.frame = g, .camera = camera, .volume = volume, .crossHair = false};
  input.erased = &erased;
  const auto tinted = [&] {
    std::vector<glm::ivec2> found;
    const Image image = draw(input, {24, 16});
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 24; ++x)
        if (pixel(image, x, y).r > pixel(image, x, y).g + 30) found.push_back({x, y});
    return found;
  };
  EXPECT_EQ(tinted(), (std::vector<glm::ivec2>{{7, 5}, {8, 5}}));

  // Painted on: what a new key brings, in the slices that have changed.
  mask.at(8, 5, 3) = 0;
  mask.at(20, 11, 3) = 1;
  erased.set(mask, Hasher("first").key());
  EXPECT_EQ(tinted(), (std::vector<glm::ivec2>{{7, 5}, {8, 5}})) << "the key says that nothing changed";
  erased.set(mask, Hasher("second").key());
  EXPECT_EQ(tinted(), (std::vector<glm::ivec2>{{7, 5}, {20, 11}}));
}

TEST_F(SliceViewTest, OutsideTheBoxIsDarker) {
  GpuVolume volume;
  volume.set(std::make_shared<Volume<float>>(Volume<float>(geometry(), 0.8f)));
  const Geometry g = geometry();
  SliceCamera camera{.plane = Plane::axial, .cursor = g.toWorld({0, 0, 3})};
  SliceViewInput input{.frame = g, .camera = camera, .volume = volume, .crossHair = false};
  input.box = {{g.toWorld({4.5, 3.5, 1.5}), g.toWorld({20.5, 12.5, 5.5})}};
  const Image image = draw(input, {240, 160});
  for (const glm::ivec2 inside : {glm::ivec2(60, 50), glm::ivec2(190, 120)})
    EXPECT_NEAR(pixel(image, inside.x, inside.y).r, 204, 1);
  for (const glm::ivec2 outside :
       {glm::ivec2(40, 80), glm::ivec2(215, 80), glm::ivec2(100, 30), glm::ivec2(100, 140)})
    EXPECT_NEAR(pixel(image, outside.x, outside.y).r, 82, 1);
  EXPECT_GT(pixel(image, 50, 80).b, pixel(image, 50, 80).r + 60) << "a line at its side";
  camera.cursor = g.toWorld({0, 0, 6});  // a slice beside the box
  EXPECT_NEAR(pixel(draw(input, {240, 160}), 100, 80).r, 82, 1);
}

TEST_F(SliceViewTest, CrossHairHasTheColoursOfTheOtherPlanes) {
  GpuVolume volume;
  volume.set(std::make_shared<Volume<float>>(Volume<float>(geometry(), 0.0f)));
  const Geometry g = geometry();
  const SliceCamera camera{.plane = Plane::axial, .cursor = g.toWorld({12, 8, 3})};
  const Image image = draw({.frame = g, .camera = camera, .volume = volume}, {240, 160});
  const glm::ivec3 horizontal = pixel(image, 20, 85), vertical = pixel(image, 125, 10);
  EXPECT_GT(horizontal.g, horizontal.r + 20) << "coronal is green";
  EXPECT_GT(vertical.r, vertical.b + 60) << "sagittal is yellow";
  EXPECT_GT(vertical.g, vertical.b + 60);
  EXPECT_EQ(pixel(image, 60, 40), glm::ivec3(0));
}

}  // namespace
}  // namespace sonoskin
