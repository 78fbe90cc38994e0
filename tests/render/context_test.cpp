#include "render/gl/context.h"

#include <gtest/gtest.h>

#include "tests/render/support/gl_test.h"

namespace sonoskin::gl {
namespace {

TEST(Context, EglReachesOpenGl45) {
  const auto context = makeOffscreenContext(Backend::egl);
  EXPECT_NE(glInfo().find("OpenGL 4."), std::string::npos) << glInfo();
}

TEST(Context, OsMesaReachesOpenGl45) {
  const auto context = makeOffscreenContext(Backend::osmesa);
  EXPECT_NE(glInfo().find("OpenGL 4.5"), std::string::npos) << glInfo();
}

TEST(Context, LibrariesTakeTurns) {
  const auto egl = makeOffscreenContext(Backend::egl);
  const auto osMesa = makeOffscreenContext(Backend::osmesa);
  egl->makeCurrent();
  EXPECT_FALSE(glInfo().empty());
  osMesa->makeCurrent();
  EXPECT_FALSE(glInfo().empty());
}

TEST(Context, LaterContextOutlivesAnEarlierOne) {
  auto first = makeOffscreenContext(Backend::egl);
  const auto second = makeOffscreenContext(Backend::egl);
  first.reset();
  EXPECT_FALSE(glInfo().empty());
}

}  // namespace
}  // namespace sonoskin::gl
