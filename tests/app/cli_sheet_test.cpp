// `sonoskin sheet` from outside: its cells are the pictures of `render`, and what cannot be done is said in a sentence.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/io/image.h"
#include "tests/app/cli_support.h"

namespace sonoskin::test {
namespace {

using Words = std::vector<std::string>;

Words joined(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// part: the pixels of a cell.
Image part(const Image& sheet, const nlohmann::json& corner, const nlohmann::json& size) {
  Image cell{size[0], size[1], {}};
  for (int y = 0; y < cell.height; ++y) {
    const auto row =
        sheet.rgba.begin() + 4 * ((corner[1].get<int>() + y) * sheet.width + corner[0].get<int>());
    cell.rgba.insert(cell.rgba.end(), row, row + 4 * cell.width);
  }
  return cell;
}

// The sheet, and what was said of it.
struct Made {
  Image image;
  nlohmann::json json;
};
Made makeSheet(const TempFolder& folder, const Words& options) {
  const std::string file = (folder / "sheet.png").string();
  const ProgramResult result =
      sonoskin(withSmall(joined({"sheet", "phantom", "--out", file, "--json"}, options)));
  EXPECT_EQ(result.status, 0) << result.err;
  return {readPng(file), nlohmann::json::parse(result.out)};
}

Image rendered(const TempFolder& folder, const Words& options) {
  const std::string file = (folder / "one.png").string();
  const ProgramResult result = sonoskin(withSmall(joined({"render", "phantom", "--out", file}, options)));
  EXPECT_EQ(result.status, 0) << result.err;
  return readPng(file);
}

double secondsOf(const nlohmann::json& stages, const std::string& name) {
  for (const auto& stage : stages)
    if (stage["name"] == name) return stage["seconds"];
  return -1;
}

TEST(SheetCommand, ItsCellsAreThePicturesOfRender) {
  const TempFolder folder;
  const Words view{"--view", "slice", "--plane", "coronal", "--size", "120x90"};
  const Made sheet = makeSheet(folder, joined(view, {"--over", "beta=0,1", "--over", "v_iso=0.2,0.3,0.4"}));
  EXPECT_EQ(sheet.json["grid"], (nlohmann::json{2, 3}));
  ASSERT_EQ(sheet.json["cells"].size(), 6u);
  EXPECT_EQ(sheet.json["over"][0]["symbol"], "β");
  const nlohmann::json& cell = sheet.json["cells"][3];  // second row, second column
  EXPECT_EQ(cell["values"], (nlohmann::json{"1", "0.3"}));
  const Image alone =
      rendered(folder, joined(view, {"--classification.beta", "1", "--classification.isoValue", "0.3"}));
  EXPECT_EQ(part(sheet.image, cell["corner"], sheet.json["cell_size"]).rgba, alone.rgba);
  const nlohmann::json& other = sheet.json["cells"][0];
  EXPECT_NE(part(sheet.image, other["corner"], sheet.json["cell_size"]).rgba, alone.rgba);
}

TEST(SheetCommand, OfASurfaceTheCellOfTheCurrentValueIsFramed) {
  const TempFolder folder;
  const Words view{"--view", "mesh", "--camera", "face", "--size", "120x90"};
  const Made sheet = makeSheet(folder, joined(view, {"--over", "classification.alpha=0.5,1"}));
  const nlohmann::json& cells = sheet.json["cells"];
  EXPECT_FALSE(cells[0]["current"].get<bool>());
  EXPECT_TRUE(cells[1]["current"].get<bool>());
  const Image alone = rendered(folder, view);
  EXPECT_EQ(part(sheet.image, cells[1]["corner"], sheet.json["cell_size"]).rgba, alone.rgba);
  const auto before = [&](const nlohmann::json& corner) {
    return part(sheet.image, {corner[0].get<int>() - 2, corner[1].get<int>()}, {1, 1}).rgba;
  };
  EXPECT_GT(before(cells[1]["corner"])[0], 200);
  EXPECT_LT(before(cells[0]["corner"])[0], 60);
}

// Values of a later stage do not have the volume classified again, whichever of the two comes first.
TEST(SheetCommand, OnlyWhatChangesIsComputed) {
  const TempFolder folder;
  const Words small{"--view", "mesh", "--size", "64x48"};
  const nlohmann::json one = makeSheet(folder, joined(small, {"--over", "mesh.resolution=50,60,70,80"})).json;
  int lines = 0;
  const ProgramResult result =
      sonoskin(withSmall(joined({"sheet", "phantom", "--out", (folder / "two.png").string(), "--over",
                                 "alpha=0.5,1", "--over", "mesh.resolution=50,60,70"},
                                small)));
  ASSERT_EQ(result.status, 0) << result.err;
  std::vector<std::string> order;
  for (std::size_t at = result.err.find(" of 6: "); at != std::string::npos;
       at = result.err.find(" of 6: ", at + 1), ++lines)
    order.push_back(result.err.substr(at + 7, result.err.find("   ", at) - at - 7));
  EXPECT_EQ(order, (Words{"α 0.5", "α 0.5", "α 0.5", "α 1", "α 1", "α 1"})) << result.err;
  EXPECT_GT(secondsOf(one["stages"], "classification"), 0);
  EXPECT_EQ(one["grid"], (nlohmann::json{4, 1}));
}

TEST(SheetCommand, WhatCannotBeDoneIsOneSentence) {
  const TempFolder folder;
  const std::string file = (folder / "sheet.png").string();
  const struct {
    Words over;
    const char* says;
  } kWrong[] = {{{"beta=0.5,9"}, "--over beta=0.5,9: \"9\" lies outside of 0 .. 4"},
                {{"beta="}, "names no values"},
                {{"beta"}, "names no values"},
                {{"nothing=1"}, "There is no parameter nothing"},
                {{"method=1"}, "may be"},
                {{"beta=1,1.0"}, "has 1 twice"},
                {{"beta=1,x"}, "--over beta=1,x: \"x\" is not a number; give"},
                {{"beta=1,,2"}, "--over beta=1,,2: \"\" is not a number; give"},
                {{"v_iso=0,-0"}, "twice; name it once"},
                {{"region.cutLow=1"}, "several numbers"},
                {{"scan.time=1,2"}, "how it is read"},
                {{"beta=1,2", "classification.beta=3"}, "names classification.beta twice"},
                {{"beta=1", "alpha=1", "gamma=1"}, "one or two parameters"}};
  for (const auto& wrong : kWrong) {
    Words words{"sheet", "phantom", "--out", file};
    for (const std::string& over : wrong.over) words.insert(words.end(), {"--over", over});
    const ProgramResult result = sonoskin(words);
    EXPECT_EQ(result.status, 2) << wrong.over[0] << result.err;
    EXPECT_NE(result.err.find(wrong.says), std::string::npos) << wrong.over[0] << ": " << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
  const ProgramResult large =
      sonoskin({"sheet", "phantom", "--out", file, "--size", "8192x8192", "--over", "beta=1,2,3"});
  EXPECT_EQ(large.status, 2);
  EXPECT_NE(large.err.find("fewer values"), std::string::npos) << large.err;
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace sonoskin::test
