#include "render/gl/gpu_timer.h"

#include <gtest/gtest.h>

#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin::gl {
namespace {

class GpuTimerTest : public GlTest {};

TEST_F(GpuTimerTest, NothingDrawnTakesNoTime) {
  GpuTimer timer;
  timer.begin();
  timer.end();
  EXPECT_LT(timer.seconds(), 1);
}

TEST_F(GpuTimerTest, MeasuresWhatLiesBetween) {
  GpuTimer timer;
  EXPECT_EQ(timer.seconds(), 0);
  const Framebuffer target({.size = {512, 512}});
  Program program({"common/fullscreen.vert", "volume/finish.frag"});
  timer.begin();
  target.bind();
  program.use();
  for (int i = 0; i < 20; ++i) drawFullScreen();
  timer.end();
  EXPECT_GT(timer.seconds(), 0);
  EXPECT_LT(timer.seconds(), 60);
}

}  // namespace
}  // namespace sonoskin::gl
