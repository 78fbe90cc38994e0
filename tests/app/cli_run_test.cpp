// `sonoskin run` from outside: what it writes, what it leaves after a failure, how it stops.
#include <gtest/gtest.h>
#include <signal.h>

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/base/timer.h"
#include "core/base/version.h"
#include "core/io/image.h"
#include "core/io/mesh_reader.h"
#include "core/io/volume_writer.h"
#include "tests/app/cli_support.h"

namespace sonoskin::test {
namespace {

using Names = std::vector<std::string>;

const Names kResults{"mesh.ply", "mesh.png",   "recipe.json", "report.json",
                     "skin.png", "slices.png", "truth.ply",   "volume.png"};

TEST(RunCommand, WritesTheFolderAndOneJsonObject) {
  const TempFolder folder;
  const ProgramResult result =
      sonoskin(withSmall({"run", "phantom", "--out", (folder / "a/b").string(), "--json", "--size", "160x120",
                          "--keep", "classified,thinned,points", "--export", "ply,stl"}));
  ASSERT_EQ(result.status, 0) << result.err;
  Names expected = kResults;
  for (const char* extra : {"classified.nrrd", "thinned.nrrd", "points.ply", "mesh.stl"})
    expected.push_back(extra);
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(filesBelow(folder / "a/b"), expected);

  const nlohmann::json report = nlohmann::json::parse(result.out);
  EXPECT_EQ(fileText(folder / "a/b/report.json"), result.out.substr(0, result.out.size() - 1));
  EXPECT_EQ(report["version"], kVersion);
  EXPECT_EQ(report["input"], "phantom");
  EXPECT_EQ(report["dims"], (nlohmann::json{117, 64, 31}));
  EXPECT_EQ(report["spacing_mm"].size(), 3u);
  for (const char* key :
       {"points", "centres", "global_error", "triangles", "area_mm2", "peak_memory_bytes", "threads"})
    EXPECT_GT(report[key].get<double>(), 0) << key;
  EXPECT_FALSE(report["gl"].get<std::string>().empty());
  EXPECT_GT(report["stages"].size(), 5u);
  for (const auto& stage : report["stages"]) {
    EXPECT_TRUE(stage["name"].is_string());
    EXPECT_GE(stage["seconds"].get<double>(), 0);
    EXPECT_TRUE(stage["bytes"].is_number_unsigned());
  }
  EXPECT_GE(report["face"]["confidence"].get<double>(), 0);
  EXPECT_TRUE(report["warnings"].empty()) << report["warnings"];
  EXPECT_EQ(result.err.find("sonoskin: warning"), std::string::npos) << result.err;
  EXPECT_TRUE(report["iso"]["automatic"].get<bool>());
  EXPECT_LT(report["iso"]["fluid"].get<double>(), report["iso"]["edge"].get<double>());
  EXPECT_LT(report["iso"]["least"].get<double>(), report["iso"]["most"].get<double>());
  const Image picture = readPng(folder / "a/b/skin.png");
  EXPECT_EQ(picture.width, 160);
  EXPECT_EQ(picture.height, 120);
}

// A ball that is as sharp all around, in air that is not quite even: as a CT shows it.
Volume<float> ballInAir() {
  Geometry g;
  g.dims = {48, 48, 48};
  g.spacing = glm::dvec3(2);
  Volume<float> ball(g);
  for (int k = 0; k < 48; ++k)
    for (int j = 0; j < 48; ++j)
      for (int i = 0; i < 48; ++i) {
        const float d = 2 * glm::length(glm::vec3(i, j, k) - glm::vec3(23.5f));
        ball.at(i, j, k) = (d > 36   ? 0.02f
                            : d > 28 ? 0.6f
                                     : 0.3f) +
                           0.001f * float((7 * i + 11 * j + 13 * k) % 10);
      }
  return ball;
}

TEST(RunCommand, WarnsOfWhatIsNoSkinAndMakesItsSurface) {
  const TempFolder folder;
  const std::filesystem::path file = folder / "ball.nrrd";
  writeVolume(file, ballInAir());
  const ProgramResult result = sonoskin({"run", file.string(), "--out", (folder / "out").string(), "--json",
                                         "--size", "64x64", "--mesh.resolution", "60"});
  ASSERT_EQ(result.status, 0) << result.err;
  const nlohmann::json report = nlohmann::json::parse(result.out);
  ASSERT_EQ(report["warnings"].size(), 1u) << report["warnings"];
  EXPECT_NE(result.err.find("sonoskin: warning: " + report["warnings"][0].get<std::string>() + "\n"),
            std::string::npos)
      << result.err;
  EXPECT_GT(report["triangles"].get<int>(), 0);
}

// Notes and warnings are on standard error and in the report, in the file as in the result; and name no file.
TEST(RunCommand, WhatIsSaidIsInTheReport) {
  const TempFolder folder;
  const Volume<float> ball = ballInAir();
  const glm::ivec3 d = ball.geometry.dims;
  std::string colours;
  for (const float v : ball.data) colours += std::string(3, char(int(255 * v)));
  const auto file = folder.write("Doe^Jane.nrrd", fmt::format("NRRD0004\ntype: uint8\ndimension: 4\n"
                                                              "sizes: 3 {} {} {}\nencoding: raw\n"
                                                              "kinds: RGB-color domain domain domain\n\n",
                                                              d.x, d.y, d.z) +
                                                      colours);
  const ProgramResult result = sonoskin({"run", file.string(), "--out", (folder / "out").string(), "--json",
                                         "--size", "64x64", "--mesh.resolution", "60"});
  ASSERT_EQ(result.status, 0) << result.err;
  const nlohmann::json printed = nlohmann::json::parse(result.out),
                       written = nlohmann::json::parse(fileText(folder / "out/report.json"));
  for (const nlohmann::json& report : {printed, written}) {
    EXPECT_NE(report["notes"].dump().find("is in colour"), std::string::npos) << report["notes"];
    EXPECT_NE(report["warnings"].dump().find("no spacing"), std::string::npos) << report["warnings"];
    for (const char* kind : {"notes", "warnings"})
      for (const std::string sentence : report[kind]) {
        EXPECT_NE(result.err.find(": " + sentence + "\n"), std::string::npos) << sentence << result.err;
        EXPECT_EQ(sentence.find("Doe"), std::string::npos) << sentence;
      }
  }
}

// Not only a run doubts a scan.
TEST(RenderCommand, WarnsOfWhatIsNoSkin) {
  const TempFolder folder;
  writeVolume(folder / "ball.nrrd", ballInAir());
  const ProgramResult result =
      sonoskin({"render", (folder / "ball.nrrd").string(), "--out", (folder / "a.png").string(), "--json",
                "--view", "mesh", "--size", "64x64", "--mesh.resolution", "60"});
  ASSERT_EQ(result.status, 0) << result.err;
  const nlohmann::json json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json["warnings"].size(), 1u) << result.out;
  EXPECT_NE(result.err.find("sonoskin: warning: " + json["warnings"][0].get<std::string>()),
            std::string::npos)
      << result.err;
}

TEST(RunCommand, WritesASolidThatInfoFindsPrintable) {
  const TempFolder folder;
  const ProgramResult result =
      sonoskin(withSmall({"run", "phantom", "--out", (folder / "out").string(), "--json", "--size", "64x64",
                          "--export", "ply,3mf", "--print.form", "block", "--print.scale", "0.5"}));
  ASSERT_EQ(result.status, 0) << result.err;
  const nlohmann::json report = nlohmann::json::parse(result.out);
  EXPECT_FALSE(report["mesh"]["closed"].get<bool>());
  EXPECT_EQ(report["mesh"]["self_intersections"], 0);
  EXPECT_TRUE(report["print"]["closed"].get<bool>() && report["print"]["manifold"].get<bool>());
  EXPECT_EQ(report["print"]["self_intersections"], 0);
  for (const char* name : {"print.stl", "print.3mf"}) {
    const ProgramResult info = sonoskin({"info", (folder / "out" / name).string(), "--json", "--name-input"});
    ASSERT_EQ(info.status, 0) << info.err;
    const nlohmann::json facts = nlohmann::json::parse(info.out);
    EXPECT_EQ(facts["file"], name);
    EXPECT_TRUE(facts["printable"].get<bool>()) << info.out;
    EXPECT_NEAR(facts["volume_mm3"].get<double>(), report["print"]["volume_mm3"].get<double>(), 1);
  }
  const ProgramResult text = sonoskin({"info", (folder / "out/mesh.ply").string()});
  EXPECT_NE(text.out.find("printable  no"), std::string::npos) << text.out;
}

// A spacing that the file lacks is given by an option, and is in the recipe.
TEST(RunCommand, TakesTheSpacingThatAFileLacks) {
  const TempFolder folder;
  std::string bytes = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 40 40 40\nencoding: raw\n\n";
  for (int v = 0; v < 40 * 40 * 40; ++v) {
    const glm::vec3 at(v % 40, v / 40 % 40, v / 1600);
    bytes += char(glm::length(at - 19.5f) < 12 ? 100 : 10 + v % 3);
  }
  const std::string file = folder.write("ball.nrrd", bytes).string();
  const auto run = [&](const char* out, std::vector<std::string> more) {
    std::vector<std::string> arguments{"run",    file,     "--out", (folder / out).string(),
                                       "--json", "--size", "64x64", "--mesh.resolution",
                                       "50"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult result = sonoskin(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::json::parse(result.out);
  };
  const nlohmann::json unknown = run("1", {}), given = run("2", {"--scan.spacing", "0.8,0.8,0.8"}),
                       again = run("3", {"--recipe", (folder / "2/recipe.json").string()});
  EXPECT_FALSE(unknown["spacing_known"].get<bool>());
  EXPECT_TRUE(given["spacing_known"].get<bool>());
  EXPECT_EQ(given["spacing_mm"], (nlohmann::json{0.8, 0.8, 0.8}));
  EXPECT_EQ(fileText(folder / "2/mesh.ply"), fileText(folder / "3/mesh.ply"));
  EXPECT_NE(fileText(folder / "1/mesh.ply"), fileText(folder / "2/mesh.ply"));
}

TEST(RunCommand, ItsRecipeRepeatsItExactlyOnAnyNumberOfThreads) {
  const TempFolder folder;
  const Names first =
      withSmall({"run", "phantom", "--out", (folder / "1").string(), "--size", "64x64", "--threads", "1"});
  ASSERT_EQ(sonoskin(first).status, 0);
  ASSERT_EQ(sonoskin({"run", "phantom", "--out", (folder / "2").string(), "--size", "64x64", "--recipe",
                      (folder / "1/recipe.json").string(), "--threads", "3"})
                .status,
            0);
  for (const char* name : {"mesh.ply", "truth.ply", "recipe.json", "slices.png"})
    EXPECT_EQ(fileText(folder / "1" / name), fileText(folder / "2" / name)) << name;
}

// The points of a run whose mask is the half of the volume toward the head lie there, and the report tells how far they
// were moved.
TEST(RunCommand, AMaskTellsWhatWasScanned) {
  const TempFolder folder;
  std::string mask = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 117 64 31\nencoding: raw\n\n";
  for (int row = 0; row < 64 * 31; ++row) mask += std::string(58, '\x01') + std::string(59, '\0');
  const std::string file = folder.write("mask.nrrd", mask).string();
  const ProgramResult result = sonoskin(withSmall(
      {"run", "phantom", "--out", (folder / "out").string(), "--mask", file, "--json", "--size", "64x64"}));
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_GT(nlohmann::json::parse(result.out)["edge"]["depth_mm"].get<double>(), 0.2);
  const Mesh mesh = readMesh(folder / "out/mesh.ply");
  ASSERT_GT(mesh.positions.size(), 1000u);
  for (const glm::vec3& p : mesh.positions) EXPECT_LT(p.x, 58 * 1.2f + 2);

  const ProgramResult wrong = sonoskin(
      {"run", "phantom", "--out", (folder / "no").string(), "--mask", file, "--phantom.dims", "64x64x31"});
  EXPECT_EQ(wrong.status, 3);
  EXPECT_NE(wrong.err.find("The mask has 117 x 64 x 31 voxels, but the volume 64 x 64 x 31"),
            std::string::npos)
      << wrong.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "no"));
}

// What is erased, and what is cut away, is not there; the recipe brings the cut back.
TEST(RunCommand, ErasedAndCutPartsHaveNoSurface) {
  const TempFolder folder;
  const std::string header = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 117 64 31\nencoding: raw\n\n";
  std::string erased = header;
  for (int row = 0; row < 64 * 31; ++row) erased += std::string(50, '\x07') + std::string(67, '\0');
  const std::string file = folder.write("erased.nrrd", erased).string();
  const ProgramResult result =
      sonoskin(withSmall({"run", "phantom", "--out", (folder / "out").string(), "--erase", file,
                          "--region.cutHigh", "40,0,0", "--size", "64x64"}));
  ASSERT_EQ(result.status, 0) << result.err;
  const Mesh mesh = readMesh(folder / "out/mesh.ply");
  ASSERT_GT(mesh.positions.size(), 500u);
  for (const glm::vec3& p : mesh.positions) {
    EXPECT_GT(p.x, 50 * 1.2f - 2.5f);
    EXPECT_LT(p.x, 116 * 1.2f - 40 + 2.5f);
  }
  EXPECT_EQ(nlohmann::json::parse(fileText(folder / "out/report.json"))["erased_voxels"], 50 * 64 * 31);
  EXPECT_NE(fileText(folder / "out/recipe.json").find("\"cutHigh\": [\n      40.0"), std::string::npos);

  const auto refusal = [&](const std::string& bytes, const std::string& dims) {
    const std::string bad = folder.write("bad.nrrd", bytes).string();
    const ProgramResult refused = sonoskin(
        {"run", "phantom", "--out", (folder / "no").string(), "--erase", bad, "--phantom.dims", dims});
    EXPECT_EQ(refused.status, 3);
    EXPECT_FALSE(std::filesystem::exists(folder / "no"));
    return refused.err;
  };
  const std::string wrong = refusal(erased, "64x64x31");
  EXPECT_NE(wrong.find("The erased volume has 117 x 64 x 31 voxels, but the volume 64 x 64 x 31"),
            std::string::npos)
      << wrong;
  EXPECT_NE(refusal("no volume at all", "64x64x31").find("bad.nrrd"), std::string::npos);
  EXPECT_NE(refusal(header + "too short", "117x64x31").find("bad.nrrd"), std::string::npos);
}

TEST(RunCommand, AFailureLeavesNothingBehind) {
  const TempFolder folder;
  const auto bad = folder.write("bad.nrrd",
                                "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 40 40 40\n"
                                "encoding: raw\n\nfar too few bytes");
  const ProgramResult result = sonoskin({"run", bad.string(), "--out", (folder / "a/b").string()});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(filesBelow(folder.path()), Names{"bad.nrrd"});
}

TEST(RunCommand, AFailureKeepsEarlierResults) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "out");
  folder.write("out/mesh.ply", "an earlier mesh");
  folder.write("out/notes.txt", "somebody's notes");
  const auto bad = folder.write("bad.nrrd", "");
  EXPECT_EQ(sonoskin({"run", bad.string(), "--out", (folder / "out").string()}).status, 3);
  EXPECT_EQ(filesBelow(folder / "out"), (Names{"mesh.ply", "notes.txt"}));
  EXPECT_EQ(fileText(folder / "out/mesh.ply"), "an earlier mesh");
}

TEST(RunCommand, ASecondRunReplacesTheResultsAndLeavesOtherFiles) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "out");
  folder.write("out/mesh.ply", "an earlier mesh");
  folder.write("out/notes.txt", "somebody's notes");
  ASSERT_EQ(sonoskin(withSmall({"run", "phantom", "--out", (folder / "out").string()})).status, 0);
  EXPECT_TRUE(fileText(folder / "out/mesh.ply").starts_with("ply\n"));
  EXPECT_EQ(fileText(folder / "out/notes.txt"), "somebody's notes");
}

// Starts a run at full size, asks it to stop `delay` seconds after it listens, and gives the seconds until it did.
double secondsToStop(double delay, int signalNumber) {
  const TempFolder folder, output;
  RunningProgram program(SONOSKIN_PROGRAM, {"run", "phantom", "--out", (folder / "out").string()},
                         output.path());
  while (program.running() && !program.catches(signalNumber))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::this_thread::sleep_for(std::chrono::duration<double>(delay));
  EXPECT_TRUE(program.running()) << "it was over before it could be stopped";
  const Timer timer;
  program.signal(signalNumber);
  const ProgramResult result = program.wait();
  const double seconds = timer.seconds();
  EXPECT_EQ(result.status, 4);
  EXPECT_NE(result.err.find("sonoskin: error: Cancelled"), std::string::npos) << result.err;
  // Nothing, or where pictures were being drawn the surface with all that belongs to it.
  const bool surfaceStands = result.err.find("the surface is written") != std::string::npos;
  const Names files =
      surfaceStands ? Names{"out/mesh.ply", "out/recipe.json", "out/report.json", "out/truth.ply"} : Names{};
  EXPECT_EQ(filesBelow(folder.path()), files);
  return seconds;
}

TEST(RunCommand, StopsAtOnceOnInterrupt) {
  for (const double delay : {0.2, 1.0, 2.2}) {
    const double seconds = secondsToStop(delay, SIGINT);
    RecordProperty("seconds_to_stop_after_" + std::to_string(delay), std::to_string(seconds));
    EXPECT_LT(seconds, 2) << "interrupted after " << delay << " s";  // 0.3 on a quiet machine
  }
  EXPECT_LT(secondsToStop(0.5, SIGTERM), 2);
}

}  // namespace
}  // namespace sonoskin::test
