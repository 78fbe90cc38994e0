#include "render/pictures.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/io/volume_reader.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {
namespace {

class PicturesTest : public GlTest {};

TEST_F(PicturesTest, RefuseSizesThatCannotBe) {
  PictureOptions options;
  const auto mesh = std::make_shared<Mesh>(sphereMesh({0, 0, 0}, 5, 8));
  for (const glm::ivec2 size : {glm::ivec2(0, 100), glm::ivec2(100, -1), glm::ivec2(100, 9000)}) {
    options.size = size;
    EXPECT_THROW(pictureOfMesh(context(), mesh, MeshLook::clay, options), Error);
  }
  options.size = {64, 64};
  options.camera = "nowhere";
  EXPECT_THROW(pictureOfMesh(context(), mesh, MeshLook::clay, options), Error);
}

TEST_F(PicturesTest, VolumeRefusesAnIsoValueOutsideTheRange) {
  Geometry g;
  g.dims = glm::ivec3(8);
  const auto volume = std::make_shared<Volume<float>>(g);
  EXPECT_THROW(pictureOfVolume(context(), volume, {.iso = 0}, {.size = {32, 32}}), Error);
  EXPECT_THROW(pictureOfVolume(context(), volume, {.iso = 1.5f}, {.size = {32, 32}}), Error);
}

TEST_F(PicturesTest, SlicesHaveAColumnForWhatIsThere) {
  Geometry g;
  g.dims = {30, 20, 10};
  SlicesInput input{.raw = std::make_shared<Volume<float>>(Volume<float>(g, 0.2f)),
                    .classified = std::make_shared<Volume<float>>(Volume<float>(g, 0.8f)),
                    .thinned = std::make_shared<Volume<std::uint8_t>>(Volume<std::uint8_t>(g, 255)),
                    .cursor = g.toWorld({2, 2, 2})};
  const Image three = pictureOfSlices(context(), input, {306, 306});
  const auto pixel = [](const Image& image, int x, int y) {
    const std::uint8_t* p = &image.rgba[std::size_t(4 * (y * image.width + x))];
    return glm::ivec3(p[0], p[1], p[2]);
  };
  EXPECT_NEAR(pixel(three, 50, 50).r, 51, 1);
  EXPECT_NEAR(pixel(three, 152, 50).r, 204, 1);
  EXPECT_GT(pixel(three, 255, 50).r, pixel(three, 255, 50).b + 100) << "thinned in amber";
  input.classified.reset();
  input.thinned.reset();
  EXPECT_NEAR(pixel(pictureOfSlices(context(), input, {306, 306}), 153, 50).r, 51, 1);
}

TEST(BrightMiddle, IsWhereTheBrightVoxelsAre) {
  Geometry g;
  g.dims = {30, 20, 10};
  g.spacing = {2, 1, 1};
  g.origin = {5, 5, 5};
  Volume<float> volume(g);
  volume.at(4, 5, 6) = 1;
  volume.at(6, 5, 6) = 1;
  EXPECT_LT(glm::length(brightMiddle(volume) - g.toWorld({5, 5, 6})), 1e-9);
  volume = Volume<float>(g);
  EXPECT_LT(glm::length(brightMiddle(volume) - g.toWorld({14.5, 9.5, 4.5})), 1e-9);
}

TEST_F(PicturesTest, RealFaceIsSeenFromTheProbe) {
  const std::string path = SONOSKIN_SHARED_DATA "/fetus/fetus_00.nrrd";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data at " << path;
  const Scan scan = readScan(path);
  const Image image =
      pictureOfVolume(context(), scan.volume, {.iso = 0.25f}, {.size = {160, 120}, .beam = beamOf(scan, {})});
  std::size_t bright = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) bright += image.rgba[i] > 120;
  EXPECT_GT(bright, image.rgba.size() / 4 / 10);
}

}  // namespace
}  // namespace sonoskin
