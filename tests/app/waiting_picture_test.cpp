#include "app/batch/waiting_picture.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/base/error.h"
#include "render/gl/framebuffer.h"
#include "render/gl/read_pixels.h"

namespace sonoskin {
namespace {

Image redPicture() {
  const gl::Framebuffer picture({.size = {4, 4}});
  picture.clear({1, 0, 0, 1});
  return gl::readImage(picture);
}

TEST(WaitingPicture, IsDrawnOnItsThreadWithTheContextOfThisOne) {
  const auto context = gl::makeOffscreenContext();
  const auto here = std::this_thread::get_id();
  std::atomic<bool> prepared{false};
  WaitingPicture picture([&](gl::Context& turn, const Progress& progress) {
    EXPECT_NE(std::this_thread::get_id(), here);
    progress.update(0.5);
    prepared = true;
    turn.makeCurrent();
    return redPicture();
  });
  const Image before = redPicture();  // the context is this thread's until it is handed over
  while (!prepared) std::this_thread::yield();
  EXPECT_EQ(picture.take(*context, {}).rgba, before.rgba);
  context->makeCurrent();  // and comes back
  EXPECT_EQ(redPicture().rgba, before.rgba);
}

TEST(WaitingPicture, TellsItsErrorWhereItIsTaken) {
  const auto context = gl::makeOffscreenContext();
  WaitingPicture picture([](gl::Context&, const Progress&) -> Image { throw Error("no skin"); });
  EXPECT_THROW(picture.take(*context, {}), Error);
  context->makeCurrent();
  EXPECT_EQ(redPicture().rgba[0], 255);
}

// Whoever fails before the context is handed over does not wait for ever, nor for the whole preparation.
TEST(WaitingPicture, EndsWhereNobodyTakesIt) {
  std::atomic<int> cancelled{0};
  for (const bool prepares : {true, false})
    WaitingPicture picture([&, prepares](gl::Context& turn, const Progress& progress) {
      try {
        while (prepares) {
          progress.update(0.1);
          std::this_thread::yield();
        }
        turn.makeCurrent();
      } catch (const Cancelled&) {
        ++cancelled;
        throw;
      }
      return Image{};
    });
  EXPECT_EQ(cancelled, 2);
}

TEST(WaitingPicture, StopsWhereItsTakerIsStopped) {
  const auto context = gl::makeOffscreenContext();
  ProgressSink sink;
  sink.cancel = true;
  WaitingPicture picture([](gl::Context& turn, const Progress& progress) -> Image {
    turn.makeCurrent();
    for (;;) progress.update(0.1);
  });
  EXPECT_THROW(picture.take(*context, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
