// The command line as a contract: exit status, one line for what went wrong, the recipe.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/document/parameter_text.h"
#include "core/base/version.h"
#include "core/io/mesh_writer.h"
#include "core/mesh/facts/mesh_doubts.h"
#include "core/pipeline/presets.h"
#include "tests/app/cli_support.h"
#include "tests/support/solids.h"

namespace sonoskin::test {
namespace {

void expectOneLine(const ProgramResult& result, int status) {
  EXPECT_EQ(result.status, status) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.starts_with("sonoskin: error: ")) << result.err;
  EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
}

TEST(CommandLine, WrongUsageGivesTwo) {
  const std::vector<std::vector<std::string>> wrong = {
      {"--nonsense"},
      {"no-such-command-or-file"},
      {"run"},                                                      // neither INPUT nor --out
      {"run", "phantom"},                                           // no --out
      {"run", "phantom", "--out", "/tmp/x", "--export", "doc"},     // no such format
      {"run", "phantom", "--out", "/tmp/x", "--keep", "nothing"},   // no such result
      {"run", "phantom", "--out", "/tmp/x", "--size", "800"},       // half a size
      {"run", "phantom", "--out", "/tmp/x", "--size", "9999x800"},  // too large
      {"run", "phantom", "--out", "/tmp/x", "--gl", "metal"},
      {"run", "phantom", "--out", "/tmp/x", "--threads", "0"},
      {"run", "phantom", "--out", "/tmp/x", "--classification.alpha", "much"},
      {"run", "phantom", "--out", "/tmp/x", "--classification.alpha", "99"},
      {"run", "phantom", "--out", "/tmp/x", "--classification.alfa", "1"},
      {"run", "phantom", "--out", "/tmp/x", "--phantom.dims", "10x20"},
      {"run", "phantom", "--out", "/tmp/x", "--mesh.piece", "smallest"},
      {"run", "phantom", "--out", "/tmp/x", "--mesh.piecePoint", "1,2,nan"},
      {"run", "phantom", "--out", "/tmp/x", "--preset", "best"},
      {"render", "phantom", "--out", "/tmp/x.png", "--view", "inside"},
      {"render", "phantom", "--out", "/tmp/x.png", "--camera", "sideways"},
      {"render", "phantom", "--out", "/tmp/x.bmp"},
      {"render", "phantom", "--out", "/tmp/x.png", "--look", "best"},
      {"render", "phantom", "--out", "/tmp/x.png", "--pass", "inside"},
      {"render", "phantom", "--out", "/tmp/x.png", "--quality", "medium"},
      {"render", "phantom", "--out", "/tmp/x.png", "--view", "mesh", "--pass", "albedo"},
      {"render", "phantom", "--out", "/tmp/x.png", "--view", "volume", "--reference"},
      {"render", "phantom", "--out", "/tmp/x.png", "--bake", "colour"},  // a surface is no picture
      {"render", "phantom", "--out", "/tmp/x.glb"},
      {"render", "phantom", "--out", "/tmp/x.glb", "--bake", "everything"},
      {"run", "phantom", "--out", "/tmp/x", "--bake", "colour"},  // PLY holds no pictures
      {"run", "phantom", "--out", "/tmp/x", "--light.azimuth", "400"},
      {"phantom", "--out", "/tmp/x.doc"},
      {"phantom", "--out", "/tmp/no-such-folder-of-sonoskin/x.nrrd"},
      {"compare", "only-one.ply"},
  };
  for (const auto& arguments : wrong) {
    std::string shown;
    for (const std::string& word : arguments) shown += word + " ";
    SCOPED_TRACE(shown);
    expectOneLine(sonoskin(arguments), 2);
  }
}

TEST(CommandLine, HelpAndVersionGiveZero) {
  const ProgramResult help = sonoskin({"run", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  const ProgramResult version = sonoskin({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_NE(version.out.find(kVersion), std::string::npos);
}

TEST(CommandLine, HelpNamesEveryParameterWithItsRangeAndDefault) {
  const std::string help = sonoskin({"run", "--help"}).out;
  for (const ParameterInfo& p : describeParameters({})) {
    EXPECT_NE(help.find("--" + p.name), std::string::npos) << p.name;
    EXPECT_NE(help.find(p.help), std::string::npos) << p.name;
    EXPECT_NE(help.find(p.range), std::string::npos) << p.name;
    EXPECT_NE(help.find("default " + p.value), std::string::npos) << p.name;
  }
}

TEST(CommandLine, RecipeGoesRound) {
  const TempFolder folder;
  const ProgramResult first =
      sonoskin({"recipe", "--classification.alpha", "0.7", "--mesh.piece", "largest", "--phantom.dims",
                "64x48x32", "--reconstruction.fitWeights", "on", "--mesh.piecePoint", "-1.5,2,1e3"});
  ASSERT_EQ(first.status, 0) << first.err;
  const nlohmann::json json = nlohmann::json::parse(first.out);
  EXPECT_NE(first.out, sonoskin({"recipe"}).out);
  folder.write("r.json", first.out);
  const ProgramResult second = sonoskin({"recipe", "--recipe", (folder / "r.json").string(), "--json"});
  EXPECT_EQ(second.out, first.out);
}

TEST(CommandLine, OptionsGoOnTopOfTheRecipeWhereverTheyStand) {
  const TempFolder folder;
  folder.write("r.json", sonoskin({"recipe", "--classification.alpha", "0.7"}).out);
  const std::string recipe = (folder / "r.json").string();
  const std::string expected = sonoskin({"recipe", "--classification.alpha", "0.9"}).out;
  EXPECT_EQ(sonoskin({"recipe", "--classification.alpha", "0.9", "--recipe", recipe}).out, expected);
  EXPECT_EQ(sonoskin({"recipe", "--recipe", recipe, "--classification.alpha", "0.9"}).out, expected);
}

TEST(CommandLine, PresetsGoUnderRecipeAndOptions) {
  const TempFolder folder;
  folder.write("r.json", R"({"classification":{"alpha":0.6,"gamma":0.5}})");
  const auto recipe = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "recipe");
    return nlohmann::json::parse(sonoskin(arguments).out);
  };
  const auto all = recipe({"--classification.gamma", "0.8", "--recipe", (folder / "r.json").string(),
                           "--preset", "thesis-baby-2"});
  EXPECT_EQ(all["classification"]["gamma"], 0.8);     // the option
  EXPECT_EQ(all["classification"]["alpha"], 0.6);     // the recipe
  EXPECT_EQ(all["classification"]["isoValue"], 0.3);  // the preset
  EXPECT_EQ(recipe({"--preset", "default"}), recipe({}));
}

TEST(CommandLine, HelpNamesEveryPreset) {
  const std::string help = sonoskin({"run", "--help"}).out;
  for (const Preset& preset : presets())
    EXPECT_NE(help.find(fmt::format("{}: {}", preset.name, preset.help)), std::string::npos) << preset.name;
}

TEST(CommandLine, BadRecipesGiveThree) {
  const TempFolder folder;
  const std::string path = (folder / "r.json").string();
  for (const char* text :
       {"", "{", "[]", R"({"classification":{"alfa":1}})", R"({"classification":{"alpha":"x"}})"}) {
    SCOPED_TRACE(text);
    folder.write("r.json", text);
    expectOneLine(sonoskin({"recipe", "--recipe", path}), 3);
  }
  expectOneLine(sonoskin({"recipe", "--recipe", path + ".missing"}), 3);
}

// A mesh in metres that is inside out: said, and mended.
TEST(CommandLine, MeshesInOtherUnitsAreToldAndMended) {
  const TempFolder folder;
  Mesh mesh = solid([](const glm::dvec3& x) { return ball(x, {0, 0, 0}, 40); }, {48, 48, 48}, 6);
  flipMesh(mesh);
  scaleMesh(mesh, 0.001f);
  writeMesh(folder / "m.ply", mesh);
  const std::string file = (folder / "m.ply").string(), out = (folder / "o.png").string();
  const std::vector<std::string> words{"render", file, "--out", out, "--view", "mesh", "--size", "64x64"};
  const ProgramResult told = sonoskin(words);
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_NE(told.err.find("--scale"), std::string::npos) << told.err;
  EXPECT_NE(told.err.find("--flip"), std::string::npos) << told.err;
  std::vector<std::string> mended = words;
  mended.insert(mended.end(), {"--scale", "1000", "--flip"});
  const ProgramResult result = sonoskin(mended);
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err.find("warning"), std::string::npos) << result.err;
  EXPECT_EQ(sonoskin({"render", "phantom", "--out", out, "--flip"}).status, 2);  // it would do nothing
}

TEST(CommandLine, ExplainsEveryField) {
  const std::string table = sonoskin({"recipe", "--explain"}).out;
  for (const ParameterInfo& p : describeParameters({}))
    EXPECT_NE(table.find("| `" + p.name + "` |"), std::string::npos) << p.name;
  EXPECT_NE(fileText(SONOSKIN_PARAMETERS).find(table), std::string::npos)
      << "assets/docs/parameters.md is out of date: run tests/tools/update_tables.py build/release/sonoskin";
}

}  // namespace
}  // namespace sonoskin::test
