// The recipe beside what a session saves: from it and the input alone the same surface is made, bit by bit.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/document/session.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/image.h"
#include "core/io/volume_reader.h"
#include "core/pipeline/recipe.h"
#include "tests/app/cli_support.h"
#include "tests/app/session_support.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::ballOnTheSurface;
using test::TempFolder;
using test::tinySurface;
using test::wait;

// A surface of which something was erased, and for which a parameter was changed on the way to it.
void reconstructSomething(Session& session) {
  session.openPhantom();
  ASSERT_TRUE(wait(session));
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  Parameters p = session.parameters();
  p.classification.gamma = 0.7;
  session.edit(p);
  session.commitEdit();
  ASSERT_TRUE(wait(session));
  Brush ball = ballOnTheSurface(session);
  ball.radius = 5;
  session.erase(ball);
  session.commitEdit();
  ASSERT_TRUE(wait(session));
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  ASSERT_EQ(session.state(), DocumentState::current);
}

std::vector<std::string> warningsOf(LogRecord& said) {
  std::vector<std::string> texts;
  for (const LogEntry& entry : said.take())
    if (entry.level == LogLevel::warning) texts.push_back(entry.sentence);
  return texts;
}

// What the command line makes of the recipe beside a file.
std::vector<std::uint8_t> repeated(const fs::path& file, const TempFolder& folder, const std::string& made) {
  const fs::path recipe = fs::path(file).replace_extension(".recipe.json"), out = folder / "again";
  const test::ProgramResult result = test::sonoskin({"run", "phantom", "--recipe", recipe.string(), "--out",
                                                     out.string(), "--size", "64x64", "--export", "ply,stl"});
  EXPECT_EQ(result.status, 0) << result.err;
  return readBytes(out / made);
}

TEST(SessionExport, TheRecipeBesideAMeshRepeatsIt) {
  const TempFolder folder;
  const fs::path file = folder / "face.ply";
  Session session(tinySurface());
  reconstructSomething(session);
  LogRecord said;
  session.saveMesh(file);
  ASSERT_TRUE(wait(session));
  EXPECT_TRUE(warningsOf(said).empty());
  EXPECT_EQ(repeated(file, folder, "mesh.ply"), readBytes(file));
}

TEST(SessionExport, VolumesForOtherProgramsReadBack) {
  const TempFolder folder;
  test::OpenSession session(tinySurface());
  session.saveScan(folder / "scan.nrrd");
  session.saveClassified(folder / "classified.mha");
  ASSERT_TRUE(wait(session));
  const Scan scan = readScan(folder / "scan.nrrd"), classified = readMarks(folder / "classified.mha", {});
  EXPECT_TRUE(scan.key == session.scan().key);
  ASSERT_TRUE(session.results().classified);
  EXPECT_EQ(classified.volume->data, session.results().classified->data);
}

// What is saved is the surface that is there, not the one that parameters have moved on to.
TEST(SessionExport, ASurfaceThatIsOlderKeepsItsOwnRecipeAndSaysSo) {
  const TempFolder folder;
  const fs::path file = folder / "face.ply";
  Session session(tinySurface());
  reconstructSomething(session);
  session.followParameters(false);
  Parameters moved = session.parameters();
  moved.classification.gamma = 2;
  moved.phantom.seed += 1;
  session.edit(moved);
  session.clearErased();
  ASSERT_TRUE(wait(session));
  ASSERT_EQ(session.state(), DocumentState::older);
  LogRecord said;
  session.saveMesh(file);
  ASSERT_TRUE(wait(session));
  const std::vector<std::string> warnings = warningsOf(said);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("older than the parameters"), std::string::npos);
  EXPECT_EQ(repeated(file, folder, "mesh.ply"), readBytes(file));
}

TEST(SessionExport, ASurfaceThatIsNotFinalSaysSo) {
  const TempFolder folder;
  Session session(tinySurface());
  reconstructSomething(session);
  Parameters moved = session.parameters();
  moved.classification.gamma = 2;
  session.edit(moved);
  ASSERT_TRUE(wait(session));
  ASSERT_EQ(session.state(), DocumentState::live);
  LogRecord said;
  session.saveMesh(folder / "face.ply");
  ASSERT_TRUE(wait(session));
  const std::vector<std::string> warnings = warningsOf(said);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("reconstruct it"), std::string::npos);
}

TEST(SessionExport, TheRecipeBesideASolidMakesTheSolid) {
  const TempFolder folder;
  const fs::path file = folder / "face.stl";
  Session session(tinySurface());
  reconstructSomething(session);
  session.savePrint(file);
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(repeated(file, folder, "print.stl"), readBytes(file));
}

// A picture of the mesh has the recipe of that mesh in the present light; one of the volume that of the moment.
TEST(SessionExport, PicturesHaveTheRecipeOfWhatTheyShow) {
  const TempFolder folder;
  Session session(tinySurface());
  reconstructSomething(session);
  session.followParameters(false);
  Parameters moved = session.parameters();
  moved.classification.gamma = 2;
  moved.light.azimuth = 77;
  session.edit(moved);
  ASSERT_TRUE(wait(session));
  const auto recipeOf = [&](bool showsMesh) {
    Image image;
    image.width = image.height = 1;
    image.rgba = {1, 2, 3, 255};
    const fs::path file = folder / "view.png";
    session.savePicture(
        file, [file, image](const Progress&) { writePng(file, image); }, showsMesh);
    EXPECT_TRUE(wait(session));
    Parameters read;
    readRecipe(readText(folder / "view.recipe.json", kMostRecipeBytes), read);
    return read;
  };
  EXPECT_EQ(recipeOf(true).classification.gamma, 0.7);
  EXPECT_EQ(recipeOf(true).light.azimuth, 77);
  EXPECT_EQ(recipeOf(false).classification.gamma, 2);
}

TEST(SessionExport, ARecipeBringsBackWhatWasErasedOfItsOwnScanAlone) {
  const TempFolder folder;
  Session session(tinySurface());
  reconstructSomething(session);
  const auto mask = session.erased().mask().data;
  session.saveRecipe(folder / "face.recipe.json");
  ASSERT_TRUE(wait(session));
  session.clearErased();
  session.loadRecipe(folder / "face.recipe.json");
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.erased().mask().data, mask);
  session.undo();
  EXPECT_EQ(session.erased().voxels(), 0u);

  Parameters p = tinySurface();
  p.phantom.seed += 1;
  test::OpenSession other(p);
  LogRecord said;
  other.loadRecipe(folder / "face.recipe.json");
  ASSERT_TRUE(wait(other));
  EXPECT_EQ(other.erased().voxels(), 0u);
  EXPECT_EQ(warningsOf(said).size(), 1u);
  const test::ProgramResult result =
      test::sonoskin({"run", "phantom", "--recipe", (folder / "face.recipe.json").string(), "--phantom.seed",
                      "5", "--out", (folder / "5").string(), "--size", "64x64"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("of another volume"), std::string::npos) << result.err;
}

// A recipe that was made up names the fingerprint that a session without a scan has.
TEST(SessionExport, ARecipeErasesNothingWhereNothingIsOpen) {
  const TempFolder folder;
  const std::string text =
      "{\"input\": \"" + Key().hex() + "\", \"erased\": {\"dims\": [1, 1, 1], \"counts\": [0, 1]}}";
  Session session(tinySurface());
  session.loadRecipe(folder.write("a.recipe.json", text));
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(session.erased().voxels(), 0u);
}

}  // namespace
}  // namespace sonoskin
