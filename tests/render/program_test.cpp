#include "render/gl/program.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "render/gl/read_pixels.h"
#include "tests/render/support/gl_test.h"

extern "C" void (*eglGetProcAddress(const char* name))();

namespace sonoskin::gl {
namespace {

class ProgramTest : public GlTest {};

TEST_F(ProgramTest, SaysWhereAShaderIsWrong) {
  try {
    Program({"common/fullscreen.vert", "volume/finish.frag"}, {"toneMap 1 +* 2"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("common/colour.glsl:"), std::string::npos) << error.what();
  }
}

TEST_F(ProgramTest, MovedFromProgramIsEmpty) {
  Program program({"common/fullscreen.vert", "volume/finish.frag"});
  const unsigned name = program.name();
  Program moved = std::move(program);
  EXPECT_EQ(moved.name(), name);
  EXPECT_EQ(program.name(), 0u);  // NOLINT: the state after a move is what is tested
}

// Whoever puts back what was in use before would name a program that is gone.
TEST_F(ProgramTest, AProgramThatIsGoneIsNotInUse) {
  const auto getInteger = reinterpret_cast<void (*)(unsigned, int*)>(eglGetProcAddress("glGetIntegerv"));
  const auto used = [&] {
    int name = -1;
    getInteger(0x8B8D, &name);  // GL_CURRENT_PROGRAM
    return name;
  };
  {
    Program program({"common/fullscreen.vert", "volume/finish.frag"});
    program.use();
    EXPECT_EQ(unsigned(used()), program.name());
  }
  EXPECT_EQ(used(), 0);
}

TEST_F(ProgramTest, ErrorsOfOpenGlAreCounted) {
  const int before = glErrorCount();
  Texture texture({.size = {2, 2, 0}, .format = Format::r8});
  readFloats(Texture(), 1);  // there is no texture 0 to read from
  EXPECT_GT(glErrorCount(), before);
  SetUp();  // these were meant
}

}  // namespace
}  // namespace sonoskin::gl
