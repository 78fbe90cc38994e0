// Pictures of volumes from the command line: their looks, colours and cuts, without a background, and all around.
#include <gtest/gtest.h>

#include "app/document/transfer_file.h"
#include "core/io/image.h"
#include "tests/app/cli_support.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::sonoskin;

class CliVolume : public testing::Test {
 protected:
  // A small picture of the whole simulated scan, for which nothing is computed.
  test::ProgramResult render(const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> words{"render", "phantom", "--out",   (folder / name).string(),
                                   "--view", "volume",  "--whole", "--level",
                                   "0.3",    "--size",  "96x80"};
    words.insert(words.end(), more.begin(), more.end());
    return sonoskin(test::withSmall(words));
  }
  Image picture(const std::string& name, const std::vector<std::string>& more) {
    const test::ProgramResult result = render(name, more);
    EXPECT_EQ(result.status, 0) << result.err;
    return result.status == 0 ? readPng(folder / name) : Image{};
  }
  static double mean(const Image& image, std::size_t channel) {
    double sum = 0;
    for (std::size_t i = channel; i < image.rgba.size(); i += 4) sum += image.rgba[i];
    return 4 * sum / double(image.rgba.size());
  }
  const test::TempFolder folder;
};

TEST_F(CliVolume, LooksAndColoursDiffer) {
  const Image amber = picture("amber.png", {}), grey = picture("grey.png", {"--transfer", "grey"}),
              greatest = picture("mip.png", {"--mode", "mip"}),
              bright = picture("bright.png", {"--no-shadows"});
  EXPECT_GT(mean(amber, 0), 1.2 * mean(amber, 2)) << "amber is red";
  EXPECT_NEAR(mean(grey, 0), mean(grey, 2), 12);
  EXPECT_NEAR(mean(greatest, 0), mean(greatest, 2), 12) << "a maximum is grey, the background hardly blue";
  EXPECT_GT(mean(greatest, 0), 20);
  EXPECT_GT(mean(bright, 0), mean(amber, 0));
  // A file of one's own is what the preset of the same points is.
  writeTransfer(folder / "own.json", {greyTransfer(0.3f), 0.3f});
  const Image own = picture("own.png", {"--transfer", (folder / "own.json").string()});
  EXPECT_NEAR(mean(own, 1), mean(grey, 1), 1);
}

TEST_F(CliVolume, WithoutABackgroundAndCut) {
  const Image whole = picture("whole.png", {"--mode", "iso", "--transparent"});
  const Image cut = picture("cut.png", {"--mode", "iso", "--transparent", "--clip", "camera,at=-20"});
  EXPECT_EQ(whole.rgba[3], 0) << "the corner shows nothing";
  EXPECT_GT(mean(whole, 3), 20);
  EXPECT_NE(cut.rgba, whole.rgba);
}

TEST_F(CliVolume, AllAround) {
  const test::ProgramResult result = render("turn.png", {"--turntable", "3", "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("turn_003.png"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "turn.png"));
  const Image first = readPng(folder / "turn_001.png"), third = readPng(folder / "turn_003.png");
  EXPECT_NE(first.rgba, third.rgba);
}

TEST_F(CliVolume, RefusesWhatDoesNotGoTogether) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--mode", "mip", "--transfer", "bone"},
        {"--mode", "iso", "--no-shadows"},
        {"--view", "slices", "--transparent"},
        {"--clip", "sideways"},
        {"--turntable", "1"}}) {
    const test::ProgramResult result = render("a.png", words);
    EXPECT_EQ(result.status, 2) << words.front();
    EXPECT_FALSE(fs::exists(folder / "a.png"));
  }
  EXPECT_EQ(render("a.png", {"--transfer", "none.json"}).status, 3);
}

}  // namespace
}  // namespace sonoskin
