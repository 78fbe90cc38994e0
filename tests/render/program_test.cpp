#include "render/gl/program.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "render/gl/read_pixels.h"
#include "tests/render/support/gl_test.h"

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

TEST_F(ProgramTest, ErrorsOfOpenGlAreCounted) {
  const int before = glErrorCount();
  Texture texture({.size = {2, 2, 0}, .format = Format::r8});
  readFloats(Texture(), 1);  // there is no texture 0 to read from
  EXPECT_GT(glErrorCount(), before);
  SetUp();  // these were meant
}

}  // namespace
}  // namespace sonoskin::gl
