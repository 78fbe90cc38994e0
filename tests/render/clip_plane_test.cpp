// The plane that cuts what is shown: its words, and what is left of a mesh.
#include "render/clip_plane.h"

#include "core/base/error.h"
#include "render/gl/read_pixels.h"
#include "render/mesh_view.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {
namespace {

TEST(ClipPlane, WordsNameTheSideThatIsCutAway) {
  const Box box{{-10, -20, 0}, {10, 20, 60}};
  const Camera camera = lookAlong({0, 1, 0}, {0, 0, 1}, box, 1);
  EXPECT_EQ(parseClip("", camera, box), ClipPlane{});
  const ClipPlane top = parseClip("top,at=10", camera, box);
  EXPECT_TRUE(top.keeps({0, 0, 39}));
  EXPECT_FALSE(top.keeps({0, 0, 41}));
  // The camera looks along +y: what is nearer to it has the smaller y.
  const ClipPlane near = parseClip("camera,at=-5", camera, box);
  EXPECT_TRUE(near.keeps({0, 6, 0}));
  EXPECT_FALSE(near.keeps({0, 4, 0}));
  EXPECT_TRUE(parseClip("left", camera, box).keeps({-1, 0, 0}));  // LPS: left is +x
  for (const char* words : {"sideways", "top,at=", "top,at=x", "top,near=3"})
    EXPECT_THROW(parseClip(words, camera, box), Error) << words;
}

class ClipPlaneTest : public GlTest {};

// The half of a ball that faces the camera is gone: its inside is seen.
TEST_F(ClipPlaneTest, AMeshIsCutOpen) {
  GpuMesh mesh;
  mesh.set(std::make_shared<Mesh>(sphereMesh({5, 6, 7}, 10)));
  const Camera camera = lookAlong({0, 1, 0}, {0, 0, 1}, mesh.box(), 1);
  const gl::Framebuffer target({.size = {64, 64}});
  MeshView view;
  const auto distanceAndSide = [&](const ClipPlane& clip) {
    MeshViewInput input{.mesh = mesh, .camera = camera, .lighting = portraitLighting(camera)};
    input.clip = clip;
    view.draw(input, target);
    const std::size_t middle = 32 * 64 + 32;
    const glm::vec2 terms = depthTerms(view.buffer().projection);
    const float depth = gl::readFloats(view.buffer().surface.depth(), 1)[middle];
    return std::pair(terms.x / (terms.y - depth),
                     gl::readFloats(view.buffer().surface.colour(), 4)[4 * middle + 3]);
  };
  const auto [whole, outside] = distanceAndSide({});
  EXPECT_NEAR(whole, camera.distance - 10, 0.1);
  EXPECT_GE(outside, 0);
  const auto [cut, inside] = distanceAndSide(parseClip("camera", camera, mesh.box()));
  EXPECT_NEAR(cut, camera.distance + 10, 0.1);
  EXPECT_LT(inside, 0);
}

// Without a background what is not covered is transparent, and what is covered has the colour that it has with one.
TEST_F(ClipPlaneTest, PicturesWithoutABackground) {
  GpuMesh mesh;
  mesh.set(std::make_shared<Mesh>(sphereMesh({5, 6, 7}, 10)));
  const Camera camera = lookAlong({0, 1, 0}, {0, 0, 1}, mesh.box(), 1);
  const gl::Framebuffer target({.size = {64, 64}});
  MeshView view;
  const auto picture = [&](bool background) {
    MeshViewInput input{
        .mesh = mesh, .camera = camera, .lighting = portraitLighting(camera), .supersampling = 2};
    input.lighting.background = background;
    view.draw(input, target);
    return gl::readImage(target, !background);
  };
  const Image with = picture(true), without = picture(false);
  const auto texel = [](const Image& image, int x, int y) {
    return &image.rgba[std::size_t(4 * (64 * y + x))];
  };
  EXPECT_EQ(texel(without, 1, 1)[3], 0);
  EXPECT_EQ(texel(without, 32, 32)[3], 255);
  EXPECT_EQ(texel(with, 1, 1)[3], 255);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(texel(with, 32, 32)[c], texel(without, 32, 32)[c], 1);
  int between = 0;
  for (int x = 0; x < 32; ++x) between += texel(without, x, 32)[3] > 0 && texel(without, x, 32)[3] < 255;
  EXPECT_GE(between, 1) << "the outline has no steps";
}

}  // namespace
}  // namespace sonoskin
