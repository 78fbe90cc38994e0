// What no command can do is refused in one sentence that says why, with the status of a wrong usage, and nothing is written.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/app/cli_support.h"

namespace sonoskin::test {
namespace {

using Words = std::vector<std::string>;

void expectRefused(const Words& words, const std::string& says) {
  const ProgramResult result = sonoskin(words);
  EXPECT_EQ(result.status, 2) << words.back() << ": " << result.err;
  EXPECT_NE(result.err.find(says), std::string::npos) << words.back() << ": " << result.err;
  EXPECT_EQ(result.out, "");
}

TEST(CliRefusals, NumbersThatAreNone) {
  const TempFolder folder;
  const std::string file = (folder / "picture.png").string();
  for (const char* number : {"nan", "-nan", "inf", "1e400", "", "x"}) {
    const std::string says = " is not a finite number";
    for (const Words& command : {Words{"render", "phantom"}, Words{"sheet", "phantom", "--over", "beta=1"}}) {
      Words words = command;
      words.insert(words.end(), {"--out", file, "--view", "slice", "--at", std::string(number) + ",0,0"});
      if (*number) expectRefused(withSmall(words), says);
    }
    const Words render{"render", "phantom", "--out", file};
    for (const char* option : {"--level", "--scale"}) {
      Words words = render;
      words.push_back(option + std::string("=") + number);
      if (*number) expectRefused(words, says);
    }
    Words words = render;
    words.insert(words.end(), {"--camera", std::string("azimuth=") + number});
    expectRefused(words, "--camera");
  }
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(CliRefusals, NamesThatAreTooLong) {
  const TempFolder folder;
  const std::string name = (folder / std::string(300, 'a')).string();
  expectRefused({"render", "phantom", "--out", name + ".png"}, "cannot be written (File name too long)");
  expectRefused({"render", "phantom", "--out", name + "/face.png"}, "cannot be written (File name too long)");
  expectRefused({"sheet", "phantom", "--over", "beta=1", "--out", name + ".png"}, "too long");
  expectRefused({"phantom", "--out", name + ".nrrd"}, "too long");
  expectRefused({name}, "no file named");
  const ProgramResult run = sonoskin(withSmall({"run", "phantom", "--out", name}));
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("cannot be made: File name too long"), std::string::npos) << run.err;
}

// Whatever its content: nothing is read of it before.
TEST(CliRefusals, ResultsInThePlaceOfWhatIsRead) {
  const TempFolder folder;
  const std::string file = folder.write("scan.png", "a scan").string(),
                    other = (folder / "." / "scan.png").string();
  for (const Words& command : {Words{"render"}, Words{"sheet", "--over", "beta=1"}}) {
    const auto refused = [&](const Words& more) {
      Words words = command;
      words.insert(words.end(), {"--out", other});
      words.insert(words.end(), more.begin(), more.end());
      expectRefused(words, "that is read; choose another name");
    };
    refused({file});
    refused({"phantom", "--mask", file});
    refused({"phantom", "--erase", file});
    if (command.front() == "render") refused({"phantom", "--recipe", file});
  }
  EXPECT_EQ(fileText(folder / "scan.png"), "a scan");
}

// What is wrong with a recipe or a session is said with its file's name.
TEST(CliRefusals, RecipesThatAreNone) {
  const TempFolder folder;
  const struct {
    const char *text, *says;
  } kWrong[] = {{R"({"sonoskin_session": 2, "recipe": {}})", "saved by a newer Sonoskin"},
                {R"({"sonoskin_session": 1, "recipe": null})", "holds no recipe"},
                {R"({"sonoskin_session": 1, "recipe": []})", "holds no recipe"},
                {R"({"sonoskin_session": 1})", "holds no recipe"},
                {R"({"nothing": {}})", "no group of parameters"},
                {"no JSON", "not valid JSON"}};
  for (const auto& wrong : kWrong) {
    const std::string file = folder.write("face.sonoskin", wrong.text).string();
    const ProgramResult result =
        sonoskin({"run", "phantom", "--out", (folder / "out").string(), "--recipe", file});
    EXPECT_EQ(result.status, 3) << wrong.text << result.err;
    EXPECT_NE(result.err.find(file), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(wrong.says), std::string::npos) << wrong.text << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }
}

TEST(CliRefusals, APlaceOutsideOfTheScan) {
  const TempFolder folder;
  const std::string file = (folder / "picture.png").string();
  const Words view{"--out", file, "--view", "slice", "--layer", "raw", "--size", "64x64", "--at"};
  for (const Words& command : {Words{"render", "phantom"}, Words{"sheet", "phantom", "--over", "beta=1"}}) {
    Words words = command;
    words.insert(words.end(), view.begin(), view.end());
    words.push_back("1e6,0,0");
    expectRefused(withSmall(words), "--at 1e+06,0,0 lies outside of the scan, which reaches from ");
    EXPECT_FALSE(std::filesystem::exists(file));
    words.back() = "5,5,5";
    const ProgramResult within = sonoskin(withSmall(words));
    EXPECT_EQ(within.status, 0) << within.err;
    std::filesystem::remove(file);
  }
}

}  // namespace
}  // namespace sonoskin::test
