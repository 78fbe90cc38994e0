// `sonoskin run --time`: recordings in time from outside.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/io/image.h"
#include "core/io/mesh_reader.h"
#include "tests/app/cli_support.h"
#include "tests/support/recording.h"

namespace sonoskin::test {
namespace {

using Names = std::vector<std::string>;

struct RunTime : testing::Test {
  const TempFolder folder;
  const std::string scan = (folder / "scan.nrrd").string(), out = (folder / "out").string();

  void SetUp() override {
    PhantomOptions phantom;
    phantom.dims = {117, 64, 31};
    writeRecording(scan, phantom, 3);
  }
  ProgramResult run(const std::string& time, Names more = {}) const {
    Names words{"run", scan, "--time", time, "--out", out, "--size", "64x48", "--json", "--mesh.resolution",
                "60"};
    words.insert(words.end(), more.begin(), more.end());
    return sonoskin(words);
  }
};

TEST_F(RunTime, WritesMeshesAndPicturesOfTheSteps) {
  const ProgramResult all = run("all");
  ASSERT_EQ(all.status, 0) << all.err;
  EXPECT_EQ(all.err.find("the first is used"), std::string::npos) << all.err;
  Names expected{"mesh_0001.ply", "mesh_0002.ply", "mesh_0003.ply", "recipe.json",
                 "report.json",   "skin_0001.png", "skin_0002.png", "skin_0003.png"};
  Names found = filesBelow(out);
  std::erase(found, "film.mp4");  // where ffmpeg is installed
  EXPECT_EQ(found, expected);
  const nlohmann::json report = nlohmann::json::parse(all.out);
  EXPECT_EQ(report["time_steps"], 3);
  ASSERT_EQ(report["steps"].size(), 3u);
  EXPECT_EQ(report["steps"][2]["time"], 3);
  EXPECT_EQ(readPng(folder / "out/skin_0002.png").width * readPng(folder / "out/skin_0002.png").height,
            64 * 48);
  // The same as of that step alone; and a shorter run takes away what the longer one wrote.
  const Mesh second = readMesh(folder / "out/mesh_0002.ply");
  ASSERT_EQ(run("2-2").status, 0);
  EXPECT_EQ(readMesh(folder / "out/mesh.ply").positions, second.positions);
  EXPECT_EQ(std::ranges::count(filesBelow(out), "mesh_0003.ply"), 0);
  EXPECT_EQ(std::ranges::count(filesBelow(out), "skin_0001.png"), 0);
}

TEST_F(RunTime, RefusesStepsThatAreNotThere) {
  const ProgramResult beyond = run("2-4");
  EXPECT_EQ(beyond.status, 3);
  EXPECT_NE(beyond.err.find("no steps 2 to 4"), std::string::npos) << beyond.err;
  for (const char* text : {"3-2", "0", "x", "1-", "-1", ""}) EXPECT_EQ(run(text).status, 2) << text;
  EXPECT_EQ(run("all", {"--keep", "points"}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(out));
}

// A stand-in for ffmpeg that keeps the list of pictures: each of them, in order, over and over.
TEST_F(RunTime, MakesAFilmWhereFfmpegIs) {
  folder.write("ffmpeg", "#!/bin/sh\nfor last; do :; done\ncp \"$6\" \"$last\"\n");
  ::chmod((folder / "ffmpeg").c_str(), 0700);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder.path().string() + ":" + path).c_str(), 1);
  const ProgramResult result = run("1-2");
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_EQ(result.status, 0) << result.err;
  const std::string list = fileText(folder / "out/film.mp4");
  EXPECT_EQ(list.find("file 'skin_0001.png'\nduration 0.100000\nfile 'skin_0002.png'\n"), 0u) << list;
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 2 * 30 + 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/film.txt"));
}

}  // namespace
}  // namespace sonoskin::test
