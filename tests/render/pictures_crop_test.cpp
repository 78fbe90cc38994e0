// The part of a volume that a picture shows.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "render/pictures.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {
namespace {

// A bright plate before a bright ball, seen along j.
std::shared_ptr<const Volume<float>> plateBeforeBall() {
  Geometry g;
  g.dims = {40, 40, 40};
  auto volume = std::make_shared<Volume<float>>(g);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        if ((j >= 3 && j < 8) || glm::distance(glm::vec3(i, j, k), glm::vec3(20, 26, 20)) < 9)
          volume->at(i, j, k) = 1;
  return volume;
}

class PicturesCrop : public GlTest {
 protected:
  Image draw(const std::optional<Box>& crop) {
    PictureOptions options;
    options.size = {96, 96};
    return pictureOfVolume(context(), plateBeforeBall(), {VolumeLook::surface, 0.5f, 0, crop}, options);
  }
  static int red(const Image& image, int x, int y) {
    return image.rgba[std::size_t(4 * (y * image.width + x))];
  }
};

TEST_F(PicturesCrop, RemovesWhatIsInFront) {
  const Image whole = draw({}), cropped = draw(Box{{10, 16, 10}, {30, 36, 30}});
  // The plate fills the picture but for a thin rim; of the ball alone the corners show the background.
  EXPECT_GT(red(whole, 20, 20), 90);
  EXPECT_LT(red(cropped, 8, 8), 70);
  EXPECT_GT(red(cropped, 48, 48), 90);
}

TEST_F(PicturesCrop, ACropLargerThanTheVolumeChangesNothing) {
  EXPECT_EQ(draw(Box{{-50, -50, -50}, {99, 99, 99}}).rgba, draw({}).rgba);
}

TEST_F(PicturesCrop, RefusesACropBesideTheVolume) {
  EXPECT_THROW(draw(Box{{100, 100, 100}, {110, 110, 110}}), Error);
}

}  // namespace
}  // namespace sonoskin
