// The same object in other sizes: what is not millimetres of skin looks the same.
#include <gtest/gtest.h>

#include "render/pictures.h"
#include "render/skin/skin_pictures.h"
#include "tests/render/support/gl_test.h"
#include "tests/support/image_difference.h"

namespace sonoskin {
namespace {

constexpr float kRadii[] = {5e-4f, 0.5f, 5, 500, 5000};  // mm; 50 is what they are compared with

// A ball with a smaller one before it, which casts a shadow on it.
std::shared_ptr<const Mesh> balls(float radius) {
  Mesh mesh = sphereMesh({0, 0, 0}, radius);
  const Mesh small = sphereMesh(radius * glm::vec3(-0.7f, -0.9f, 0.6f), 0.25f * radius, 32);
  const auto base = std::uint32_t(mesh.positions.size());
  for (std::size_t v = 0; v < small.positions.size(); ++v) {
    mesh.positions.push_back(small.positions[v]);
    mesh.normals.push_back(small.normals[v]);
  }
  for (const Triangle& t : small.triangles) mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return std::make_shared<const Mesh>(std::move(mesh));
}

// Nothing of it is millimetres: light neither spreads nor comes through, and there are no pores.
Parameters plain(LightKind kind) {
  Parameters p;
  p.skin.colour = SkinColour::plain;
  p.skin.width = p.skin.translucency = p.skin.detail = p.skin.flush = p.skin.mottling = p.skin.wetness = 0;
  p.light.kind = kind;
  return p;
}

class ObjectSizeTest : public GlTest {
 protected:
  ObjectSizeTest() {
    quality_.texels = 3e5;
    quality_.shadowSize = 512;
    quality_.diffusion = DiffusionMethod::points;
    options_.camera = "front,azimuth=20,elevation=10";
    options_.size = {200, 150};
  }
  Image skin(float radius, const Parameters& parameters) {
    return pictureOfSkin(context(), balls(radius), parameters, {.quality = quality_}, options_);
  }
  static void expectSame(const Image& found, const Image& expected, float radius) {
    const test::ImageDifference d = test::compareImages(found, expected);
    EXPECT_LT(d.meanError, 1.0) << radius;
    EXPECT_LT(d.badShare, 0.005) << radius;
  }

  SkinQuality quality_;
  PictureOptions options_;
};

double meanOf(const Image& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i];
  return 4 * sum / double(image.rgba.size());
}

TEST_F(ObjectSizeTest, PlainMeshesLookTheSame) {
  const Image expected = pictureOfMesh(context(), balls(50), MeshLook::clay, options_);
  EXPECT_GT(meanOf(expected), 20);
  for (const float radius : kRadii)
    expectSame(pictureOfMesh(context(), balls(radius), MeshLook::clay, options_), expected, radius);
}

TEST_F(ObjectSizeTest, PlainSkinLooksTheSameInEveryLight) {
  for (const LightKind kind : {LightKind::far, LightKind::near, LightKind::inside}) {
    const Image expected = skin(50, plain(kind));
    EXPECT_GT(meanOf(expected), 5);
    for (const float radius : kRadii) expectSame(skin(radius, plain(kind)), expected, radius);
  }
}

// Real skin: a large object tends to where light does not spread at all, a small one to even light; both can be seen.
TEST_F(ObjectSizeTest, SkinOfAnySizeIsLit) {
  for (const float radius : kRadii) EXPECT_GT(meanOf(skin(radius, {})), 15) << radius;
  Parameters shallow = plain(LightKind::far), deep = shallow;
  deep.skin.width = 1;
  expectSame(skin(5000, deep), skin(5000, shallow), 5000);
}

}  // namespace
}  // namespace sonoskin
