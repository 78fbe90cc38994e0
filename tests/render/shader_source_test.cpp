#include "render/gl/shader_source.h"

#include <gtest/gtest.h>

#include <map>

#include "core/base/error.h"

namespace sonoskin::gl {
namespace {

const std::map<std::string, std::string> kFiles{
    {"a.frag", "first\n#include \"b.glsl\"\nthird\n  # include \"c.glsl\"  \nfifth"},
    {"b.glsl", "of b\n#include \"c.glsl\"\n"},
    {"c.glsl", "of c\n#include \"a.frag\"\n"},
    {"broken.frag", "one\n#include \"nowhere.glsl\"\n"}};

std::optional<std::string> read(const std::string& name) {
  const auto found = kFiles.find(name);
  return found == kFiles.end() ? std::nullopt : std::optional(found->second);
}

ShaderSource expand(const std::string& name, std::vector<std::string> defines = {}) {
  return expandShader(name, defines, read);
}

TEST(ShaderSource, IncludesOnceAndNumbersLines) {
  const auto source = expand("a.frag", {"SKIN", "STEPS 64"});
  EXPECT_EQ(source.text,
            "#version 450 core\n#define SKIN\n#define STEPS 64\n"
            "#line 1 0\nfirst\n"
            "#line 1 1\nof b\n"
            "#line 1 2\nof c\n#line 3 2\n"
            "#line 3 1\n"
            "#line 3 0\nthird\n"
            "#line 5 0\nfifth\n");
  EXPECT_EQ(source.files, (std::vector<std::string>{"a.frag", "b.glsl", "c.glsl"}));
}

TEST(ShaderSource, MapsLogsOfAllDrivers) {
  const auto source = expand("a.frag");
  EXPECT_EQ(mapLog("1:12(5): error: no", source), "b.glsl:12: error: no\n");
  EXPECT_EQ(mapLog("2(7) : error C0000: no", source), "c.glsl:7 : error C0000: no\n");
  EXPECT_EQ(mapLog("ERROR: 0:3: no", source), "ERROR: a.frag:3: no\n");
  EXPECT_EQ(mapLog("9:3: other", source), "9:3: other\n");
}

TEST(ShaderSource, NamesTheAskerOfAMissingFile) {
  try {
    expand("broken.frag");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "the shader nowhere.glsl is missing, asked for in broken.frag:2");
  }
}

TEST(ShaderSource, ReadsTheProgramsOwnShaders) {
  ASSERT_TRUE(readShader("mesh/mesh.frag").has_value());
  EXPECT_FALSE(readShader("mesh/none.frag").has_value());
}

}  // namespace
}  // namespace sonoskin::gl
