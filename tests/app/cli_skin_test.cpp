// Skin on the command line: looks, passes, quality, baked surfaces.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/io/image.h"
#include "core/io/mesh_reader.h"
#include "core/io/mesh_writer.h"
#include "core/pipeline/phantom_landmarks.h"
#include "core/skin/skin_presets.h"
#include "tests/app/cli_support.h"
#include "tests/support/meshes.h"

namespace sonoskin::test {
namespace {

std::string ballFile(const TempFolder& folder) {
  const auto path = folder / "ball.ply";
  writeMesh(path, icosphere(4, 25, {10, 20, 30}));
  return path.string();
}

Image picture(const TempFolder& folder, const std::string& mesh, std::vector<std::string> more) {
  const std::string out = (folder / "out.png").string();
  std::vector<std::string> words{"render", mesh, "--out", out, "--size", "96x96", "--quality", "light"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = sonoskin(words);
  EXPECT_EQ(result.status, 0) << result.err;
  return result.status == 0 ? readPng(out) : Image{};
}

// The mean of red, green and blue over the middle of a picture.
glm::dvec3 middle(const Image& image) {
  glm::dvec3 sum(0);
  int count = 0;
  for (int y = image.height / 3; y < 2 * image.height / 3; ++y)
    for (int x = image.width / 3; x < 2 * image.width / 3; ++x, ++count) {
      const std::uint8_t* p = &image.rgba[4 * std::size_t(y * image.width + x)];
      sum += glm::dvec3(p[0], p[1], p[2]);
    }
  return sum / double(count);
}

TEST(CommandLineSkin, ALookChangesThePictureAndSingleOptionsGoOnTop) {
  const TempFolder folder;
  const std::string ball = ballFile(folder);
  const glm::dvec3 usual = middle(picture(folder, ball, {}));
  EXPECT_GT(usual.r, usual.b + 25) << "skin is warm";
  const glm::dvec3 plain = middle(picture(folder, ball, {"--skin.colour", "plain"}));
  EXPECT_LT(plain.r - plain.b, 0.6 * (usual.r - usual.b));
  for (const char* look : {"clay", "clinic"})
    EXPECT_GT(glm::distance(middle(picture(folder, ball, {"--look", look})), usual), 12) << look;
}

TEST(CommandLineSkin, PassesAreShown) {
  const TempFolder folder;
  const std::string ball = ballFile(folder);
  const Image skin = picture(folder, ball, {});
  const Image normals = picture(folder, ball, {"--pass", "normal"});
  EXPECT_NE(skin.rgba, normals.rgba);
  const Image light = picture(folder, ball, {"--light", "azimuth=60"});
  EXPECT_NE(skin.rgba, light.rgba);
}

TEST(CommandLineSkin, TheLookIsPartOfARecipe) {
  const ProgramResult result =
      sonoskin({"recipe", "--look", std::string(skinPresets().back().name), "--skin.wetness", "0.77"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto recipe = nlohmann::json::parse(result.out);
  const auto& group = recipe.contains("parameters") ? recipe["parameters"] : recipe;
  EXPECT_EQ(group["skin"]["wetness"], 0.77);
  SkinOptions skin;
  LightOptions light;
  applySkinPreset(skinPresets().back(), skin, light);
  EXPECT_EQ(group["light"]["warmth"], light.warmth);
}

TEST(CommandLineSkin, BakesASurfaceForOtherPrograms) {
  const TempFolder folder;
  const std::string ball = ballFile(folder), glb = (folder / "ball.glb").string();
  ProgramResult result =
      sonoskin({"render", ball, "--out", glb, "--bake", "colour", "--quality", "light", "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_GE(readMesh(glb).positions.size(), 2562u);
  EXPECT_NE(fileText(glb).find("normalTexture"), std::string::npos);
  const std::string obj = (folder / "ball.obj").string();
  result = sonoskin({"render", ball, "--out", obj, "--bake", "light", "--quality", "light"});
  ASSERT_EQ(result.status, 0) << result.err;
  const Image lit = readPng(folder / "ball_colour.png");
  EXPECT_GE(lit.width, 128);
  EXPECT_FALSE(std::filesystem::exists(folder / "ball_normal.png"));
}

// Corners of the texture in a file that was baked.
std::string textureCorners(const std::filesystem::path& obj) {
  std::string lines, line;
  for (std::istringstream text(fileText(obj)); std::getline(text, line);)
    if (line.rfind("vt ", 0) == 0) lines += line + "\n";
  return lines;
}

TEST(CommandLineSkin, AMeshKeepsItsOwnMapWhereAsked) {
  const TempFolder folder;
  // A bent strip whose map turns it by a quarter.
  std::ofstream(folder / "strip.obj")
      << "v 0 0 0\nv 10 0 0\nv 10 0 10\nv 0 0 10\nv 20 6 0\nv 20 6 10\n"
         "vt 0.1 0.9\nvt 0.1 0.5\nvt 0.5 0.5\nvt 0.5 0.9\nvt 0.1 0.05\nvt 0.5 0.05\n"
         "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 2/2 5/5 6/6\nf 2/2 6/6 3/3\n";
  const auto baked = [&](const char* name, std::vector<std::string> more) {
    std::vector<std::string> words{
        "render", (folder / "strip.obj").string(), "--out", (folder / name).string(), "--bake", "colour"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramResult result = sonoskin(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return textureCorners(folder / name);
  };
  const std::string made = baked("made.obj", {"--quality", "light"}),
                    own = baked("own.obj", {"--own-coordinates", "--quality", "light"});
  EXPECT_NE(made, own);
  EXPECT_EQ(own, baked("own2.obj", {"--quality", "light", "--own-coordinates"}));
  // One piece as in the file: higher than wide, as its own map is.
  std::istringstream numbers(own);
  glm::vec2 low(1), high(0), at;
  for (std::string vt, third; numbers >> vt >> at.x >> at.y >> third;)
    low = glm::min(low, at), high = glm::max(high, at);
  const Image map = readPng(folder / "own_colour.png");
  EXPECT_NEAR((high.y - low.y) * float(map.height) / ((high.x - low.x) * float(map.width)), 0.85 / 0.4, 0.05);
}

TEST(CommandLineSkin, ARunWritesThePhantomsLandmarksAndBakes) {
  const TempFolder folder;
  const ProgramResult result =
      sonoskin(withSmall({"run", "phantom", "--out", (folder / "out").string(), "--export", "glb", "--bake",
                          "colour", "--quality", "light", "--size", "64x64", "--json"}));
  ASSERT_EQ(result.status, 0) << result.err;
  const auto report = nlohmann::json::parse(result.out);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/skin.glb"));
  EXPECT_NE(std::ranges::count(report["files"], "skin.glb"), 0);
  const auto recipe = nlohmann::json::parse(fileText(folder / "out/recipe.json"));
  const auto& group = recipe.contains("parameters") ? recipe["parameters"] : recipe;
  EXPECT_EQ(group["landmarks"]["noseTip"], phantomLandmarks().noseTip);
}

}  // namespace
}  // namespace sonoskin::test
