// Golden pictures: each folder of tests/golden is a case that runs through the command line.
//   arguments.txt  words for `sonoskin render`, without --recipe and --out; @truth is the surface of a small phantom, which
//                  has ears and a back
//   recipe.json    its parameters
//   expected.png   what it gave when somebody last looked at it
// A failure leaves actual.png and difference.png (eight times as strong) in build/<preset>/golden/<case>.
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <sstream>

#include "tests/app/cli_support.h"
#include "tests/support/image_difference.h"

namespace sonoskin::test {
namespace {

namespace fs = std::filesystem;

// Bounds for another version of Mesa: edges move by a fraction of a pixel, shades by one or two steps.
constexpr double kMeanError = 1.0, kBadShare = 0.005;

std::vector<std::string> goldenCases() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(SONOSKIN_GOLDEN))
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

// The surface behind a small phantom's scan.
std::string phantomTruth(const fs::path& folder) {
  const fs::path truth = folder / "truth.ply";
  const ProgramResult made = sonoskin({"phantom", "--phantom.dims", "156x85x62", "--out",
                                       (folder / "scan.nrrd").string(), "--truth", truth.string()});
  EXPECT_EQ(made.status, 0) << made.err;
  return truth.string();
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, PictureIsAsExpected) {
  const fs::path folder = fs::path(SONOSKIN_GOLDEN) / GetParam();
  const fs::path results = fs::path(SONOSKIN_GOLDEN_RESULTS) / GetParam();
  fs::remove_all(results);
  fs::create_directories(results);
  std::vector<std::string> arguments = {"render"};
  for (const std::string& word : words(fileText(folder / "arguments.txt")))
    arguments.push_back(word == "@truth" ? phantomTruth(results) : word);
  const std::string actual = (results / "actual.png").string();
  arguments.insert(arguments.end(), {"--recipe", (folder / "recipe.json").string(), "--out", actual});
  const ProgramResult result = sonoskin(arguments);
  ASSERT_EQ(result.status, 0) << result.err;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP()
      << "drawn, but not compared: at -O1 rounding decides narrow choices another way than in the release";
#endif

  const ImageDifference difference = compareImages(readPng(actual), readPng(folder / "expected.png"));
  EXPECT_LT(difference.meanError, kMeanError);
  EXPECT_LT(difference.badShare, kBadShare);
  if (!HasFailure()) {
    fs::remove_all(results);
  } else if (difference.picture.width > 0) {
    writePng(results / "difference.png", difference.picture);
  }
}

INSTANTIATE_TEST_SUITE_P(, Golden, testing::ValuesIn(goldenCases()),
                         [](const auto& one) { return one.param; });

TEST(ImageDifference, FindsASmallChangeAndNoneWhereThereIsNone) {
  Image grey{4, 4, std::vector<std::uint8_t>(64, 100)};
  EXPECT_EQ(compareImages(grey, grey).meanError, 0);
  Image changed = grey;
  changed.rgba[4] = 148;
  const ImageDifference difference = compareImages(changed, grey);
  EXPECT_DOUBLE_EQ(difference.meanError, 1);  // 48 of 48 channels
  EXPECT_DOUBLE_EQ(difference.badShare, 1.0 / 16);
  EXPECT_EQ(compareImages(grey, Image{2, 2, std::vector<std::uint8_t>(16, 100)}).badShare, 1);
}

}  // namespace
}  // namespace sonoskin::test
