// What the program does with standard streams that are full, closed or gone, and with too little memory or room.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/io/atomic_file.h"
#include "tests/app/cli_support.h"
#include "tests/support/sanitized.h"

namespace sonoskin::test {
namespace {

// shell: runs the program in a shell with `words`, which may redirect; the exit status.
int shell(const std::string& before, const std::string& words) {
  const int status = std::system((before + " " SONOSKIN_PROGRAM " " + words).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 256 + WTERMSIG(status);
}

struct Streams : testing::Test {
  const TempFolder folder;
  const std::string err = (folder / "err").string();
  std::string said() const { return fileText(folder / "err"); }
};

TEST_F(Streams, AFullDiskUnderStandardOutputIsAnError) {
  for (const char* words : {"recipe", "--help", "--version"}) {
    EXPECT_EQ(shell("", std::string(words) + " >/dev/full 2>" + err), 1) << words;
    EXPECT_NE(said().find("could not be written to standard output"), std::string::npos) << said();
  }
}

TEST_F(Streams, AClosedPipeIsQuiet) {
  const std::string status = (folder / "status").string();
  std::system(
      ("(sleep 0.3; " SONOSKIN_PROGRAM " recipe 2>" + err + "; echo $? >" + status + ") | true").c_str());
  EXPECT_EQ(said(), "");
  for (int i = 0; i < 100 && fileText(folder / "status").empty(); ++i) std::system("sleep 0.05");
  EXPECT_EQ(fileText(folder / "status"), "1\n");
}

TEST_F(Streams, ClosedStreamsAreNoTrouble) {
  EXPECT_EQ(shell("", "recipe 2>&- >/dev/null"), 0);
  EXPECT_EQ(shell("", "info nothing-here.nrrd 2>&-"), 3);
  EXPECT_EQ(shell("", "info nothing-here.nrrd >&- 2>/dev/full"), 3);
  // No output takes the number of the stream that is missing.
  const std::string file = (folder / "scan.nrrd").string();
  EXPECT_EQ(shell("", "phantom --phantom.dims 40x40x40 --out " + file + " >&- 2>&- <&-"), 0);
  EXPECT_EQ(shell("", "info " + file + " >/dev/null 2>&1"), 0);
}

TEST_F(Streams, FilesThatMayNotGrowAreAnError) {
  writeBytes(folder / "scan.nrrd", "old", 3);
  const std::string file = (folder / "scan.nrrd").string();
  EXPECT_EQ(shell("ulimit -f 8;", "phantom --phantom.dims 64x64x64 --out " + file + " >/dev/null 2>&1"), 1);
  EXPECT_EQ(fileText(folder / "scan.nrrd"), "old");
  EXPECT_EQ(std::system(("test $(ls -A " + folder.path().string() + " | wc -l) = 1").c_str()), 0);
}

TEST_F(Streams, RecipesThatAreNoFilesAreRefusedAtOnce) {
  ASSERT_EQ(std::system(("mkfifo " + (folder / "pipe").string()).c_str()), 0);
  const std::string ordinary = "not an ordinary file";
  for (const auto& [recipe, words] : {std::pair{(folder / "pipe").string(), ordinary},
                                      {folder.path().string(), std::string("is a folder, not a file")},
                                      {std::string("/dev/zero"), ordinary}}) {
    EXPECT_EQ(shell("", "recipe --recipe " + recipe + " >/dev/null 2>" + err), 3) << recipe;
    EXPECT_NE(said().find(words), std::string::npos) << said();
  }
}

// Renderers end the program where memory is short: the surface is safe by then.
TEST_F(Streams, ShortMemoryCostsThePicturesAlone) {
  if (test::kSanitized) GTEST_SKIP() << "sanitizers do not run with few addresses";
  const std::string out = (folder / "out").string();
  std::string words = "run phantom --out " + out + " >/dev/null 2>" + err;
  for (const std::string& word : kSmall) words += " " + word;
  for (const int kilobytes : {900'000, 1'200'000}) {
    std::filesystem::remove_all(out);
    const int status = shell("ulimit -v " + std::to_string(kilobytes) + ";", words);
    if (status == 0) continue;  // it was enough
    EXPECT_EQ(status, 1) << said();
    EXPECT_NE(said().find("sonoskin: error: "), std::string::npos) << said();
    if (said().find("is written") == std::string::npos) continue;  // not even for the surface
    for (const char* name : {"mesh.ply", "recipe.json", "report.json"})
      EXPECT_TRUE(std::filesystem::exists(folder / "out" / name)) << name << " at " << kilobytes;
    EXPECT_FALSE(std::filesystem::exists(folder / "out/skin.png"));
  }
}

// A volume that does not fit is refused before its memory is taken, with what would make it fit, and then does.
TEST_F(Streams, AVolumeThatDoesNotFitIsOfferedAtHalfItsResolution) {
  if (test::kSanitized) GTEST_SKIP() << "sanitizers do not run with few addresses";
  std::string bytes = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 400 400 400\nspacings: 0.3 0.3 0.3\n";
  bytes += "encoding: raw\n\n";
  const std::size_t header = bytes.size();
  for (int v = 0; v < 1000; ++v) bytes += char(v % 200);
  const std::filesystem::path file = folder.write("large.nrrd", bytes);
  std::filesystem::resize_file(file, header + 400u * 400u * 400u);  // the rest are zeros that take no room
  const std::string words =
      "run " + file.string() + " --out " + (folder / "out").string() + " >/dev/null 2>" + err;
  EXPECT_EQ(shell("ulimit -v 1200000;", words), 1);
  for (const char* word : {"400 x 400 x 400", "scan.half", "scan.cutLow"})
    EXPECT_NE(said().find(word), std::string::npos) << said();
  EXPECT_EQ(shell("ulimit -v 1200000;", words + " --scan.half on"), 3) << said();
  EXPECT_EQ(said().find("of memory"), std::string::npos)
      << said();  // nothing is found in zeros, for which there is room
}

// Nothing of an earlier run stays beside a recipe that does not make it; what is not ours does.
TEST(RunFiles, OfAnEarlierRunGoWithTheNewOne) {
  const TempFolder folder;
  const std::filesystem::path out = folder / "out";
  const auto run = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"run", "phantom", "--out", out.string(), "--size", "64x64"};
    words.insert(words.end(), more.begin(), more.end());
    return sonoskin(withSmall(words));
  };
  ASSERT_EQ(run({"--export", "ply,stl", "--keep", "points"}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(out / "mesh.stl") && std::filesystem::exists(out / "points.ply"));
  writeBytes(out / "notes.txt", "mine", 4);
  nlohmann::json report = nlohmann::json::parse(fileText(out / "report.json"));
  report["files"].push_back("notes.txt");
  report["files"].push_back("../out/notes.txt");
  const std::string text = report.dump();
  writeBytes(out / "report.json", text.data(), text.size());
  ASSERT_EQ(run({}).status, 0);
  EXPECT_FALSE(std::filesystem::exists(out / "mesh.stl") || std::filesystem::exists(out / "points.ply"));
  EXPECT_TRUE(std::filesystem::exists(out / "notes.txt"));
  EXPECT_TRUE(std::filesystem::exists(out / "mesh.ply") && std::filesystem::exists(out / "skin.png"));
}

}  // namespace
}  // namespace sonoskin::test
