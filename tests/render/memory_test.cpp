// What the driver cannot hold is an error, not a black picture.
#include "render/gl/memory.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "render/gl/buffer.h"
#include "render/gl/context.h"
#include "render/gl/framebuffer.h"
#include "render/gpu_mesh.h"
#include "render/gpu_volume.h"

namespace sonoskin {
namespace {

class MemoryTest : public testing::Test {
  std::unique_ptr<gl::Context> context_ = gl::makeOffscreenContext(gl::Backend::egl);
};

constexpr int kTooLong = 1 << 20;  // no driver has textures of that side

template <class F>
std::string sentenceOf(F&& make) {
  try {
    make();
    return {};
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::system);
    return error.what();
  }
}

TEST_F(MemoryTest, TexturesAreMadeOrRefused) {
  EXPECT_NE(sentenceOf([] {
              gl::Texture({.size = {kTooLong, 2, 0}});
            }).find("1048576 x 2 texels"),
            std::string::npos);
  EXPECT_NE(sentenceOf([] {
              gl::Texture({.size = {2, 2, kTooLong}});
            }).find("2 x 2 x 1048576"),
            std::string::npos);
  EXPECT_EQ(sentenceOf([] { gl::Texture({.size = {16, 16, 0}}); }), "") << "an error that was told is over";
}

TEST_F(MemoryTest, BuffersAreMadeOrRefused) {
  EXPECT_NE(sentenceOf([] { gl::Buffer(nullptr, std::size_t(1) << 50); }), "");
  EXPECT_EQ(sentenceOf([] { gl::Buffer(nullptr, 1000); }), "");
}

TEST_F(MemoryTest, FramebuffersAreCompleteOrRefused) {
  EXPECT_NE(sentenceOf([] { gl::Framebuffer({.size = {2, kTooLong}}); }), "");
  // A depth is no colour.
  EXPECT_NE(sentenceOf([] {
              gl::Framebuffer({.size = {8, 8}, .colours = {gl::Format::depth32f}});
            }).find("draw into"),
            std::string::npos);
  gl::Framebuffer kept({.size = {8, 4}});
  EXPECT_NE(sentenceOf([&] { kept.fit({kTooLong, 1}); }), "");
  EXPECT_EQ(kept.size(), glm::ivec2(8, 4));
}

TEST_F(MemoryTest, AVolumeThatDoesNotFitIsRefused) {
  Geometry g;
  g.dims = {kTooLong, 1, 1};
  GpuVolume volume;
  volume.set(std::make_shared<const Volume<float>>(g));
  for (int i = 0; i < 2; ++i) {
    EXPECT_NE(sentenceOf([&] { volume.values(); }), "") << "in silence the second time";
    EXPECT_NE(sentenceOf([&] { volume.shades(); }), "") << "in silence the second time";
  }
}

// Some drivers tell nothing until they are asked.
TEST_F(MemoryTest, ErrorsAreSeenOnce) {
  gl::pollErrors();
  const int before = gl::glErrorCount();
  EXPECT_NE(sentenceOf([] { gl::Texture({.size = {kTooLong, 2, 0}}); }), "");
  EXPECT_EQ(gl::glErrorCount(), before + 1);
  EXPECT_FALSE(gl::lastGlError().empty());
  EXPECT_FALSE(gl::pollErrors().any);
}

}  // namespace
}  // namespace sonoskin
