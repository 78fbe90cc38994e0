// Measures of a session find their way into reports.
#include "app/document/measure_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/document/session_file.h"
#include "app/workspace/view_file.h"
#include "core/pipeline/recipe.h"
#include "tests/app/cli_support.h"

namespace sonoskin {
namespace {

const std::vector<Measure> kMeasures{
    {MeasureKind::distance, {{1, 2, 3}, {4, 6, 15}}},
    {MeasureKind::angle, {{5, 0, 0}, {2, 0, 0}, {2, 0, 7}}},
    {MeasureKind::area, {{0, 0, -1.5}, {10, 0, -1.5}, {10, 10, -1.5}, {0, 10, -1.5}}}};

std::string sessionWith(const std::vector<Measure>& measures, const std::string& recipe) {
  ViewState view;
  view.measures = measures;
  return writeSessionFile({.volume = "phantom", .recipe = recipe, .views = writeViews(view)});
}

TEST(MeasureFile, ASessionHoldsTheMeasuresOfItsViews) {
  EXPECT_EQ(measuresIn(sessionWith(kMeasures, writeRecipe({}))), kMeasures);
  EXPECT_TRUE(measuresIn(writeRecipe({})).empty()) << "a recipe has none";
  EXPECT_TRUE(measuresIn("no JSON").empty());
}

TEST(MeasureFile, WhatIsNoMeasureIsLeftOut) {
  const auto measuresOf = [](const std::string& list) {
    return measuresIn(writeSessionFile(
        {.volume = "", .recipe = writeRecipe({}), .views = R"({"measures": )" + list + "}"}));
  };
  EXPECT_TRUE(measuresOf(R"([{"kind": "distance", "marks": [[1, 2, 3]]}])").empty()) << "not complete";
  EXPECT_TRUE(measuresOf(R"([{"kind": "distance", "marks": [[1, 2, 3], [1, 2, 4], [1, 2, 5]]}])").empty());
  EXPECT_TRUE(measuresOf(R"([{"kind": "volume", "marks": [[1, 2, 3], [1, 2, 4]]}])").empty());
  EXPECT_TRUE(measuresOf(R"([{"kind": "distance", "marks": [[1, 2, 3], [1, 2, "4"]]}])").empty());
  EXPECT_TRUE(measuresOf(R"([{"kind": "distance", "marks": [[1, 2, 3], [1, 2, 1e300]]}])").empty());
  EXPECT_TRUE(measuresOf(R"([7, {"kind": 1}, {"marks": []}])").empty());
  EXPECT_TRUE(measuresOf("7").empty());
}

TEST(MeasureFile, TheReportTellsThemWithTheirMarksInMillimetres) {
  const nlohmann::json json = nlohmann::json::parse(measuresJson(kMeasures));
  ASSERT_EQ(json.size(), 3u);
  EXPECT_EQ(json[0],
            (nlohmann::json{
                {"kind", "distance"}, {"value", 13}, {"unit", "mm"}, {"marks_mm", {{1, 2, 3}, {4, 6, 15}}}}));
  EXPECT_EQ(json[1]["unit"], "degrees");
  EXPECT_NEAR(json[1]["value"].get<double>(), 90, 1e-9);
  EXPECT_EQ(json[2]["unit"], "mm2");
  EXPECT_NEAR(json[2]["value"].get<double>(), 100, 1e-9);
  EXPECT_EQ(measuresText({kMeasures[0]}), "distance 13.0 mm at 1.0, 2.0, 3.0; 4.0, 6.0, 15.0 mm\n");
}

TEST(MeasureFile, HowManyCouldNotBeReadIsTold) {
  const test::TempFolder folder;
  const std::string views = R"({"measures": [{"kind": "distance", "marks": [[1, 2, 3], [1, 2, 2e6]]},)"
                            R"({"kind": "distance", "marks": [[1, 2, 3], [1, 2, 4]]}, 7]})";
  const std::string session =
      folder.write("face.sonoskin", writeSessionFile({"phantom", writeRecipe({}), false, true, {}, views}))
          .string();
  const test::ProgramResult result = test::sonoskin({"recipe", "--recipe", session});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("2 measures of the session could not be read"), std::string::npos) << result.err;
}

// A run that is given the session: the measures are in the report of the same scan, and of no other.
TEST(MeasureFile, RunTakesThemFromASession) {
  const test::TempFolder folder;
  const auto run = [&](const char* out, std::vector<std::string> more) {
    std::vector<std::string> words =
        test::withSmall({"run", "phantom", "--out", (folder / out).string(), "--json", "--size", "64x64"});
    words.insert(words.end(), more.begin(), more.end());
    const test::ProgramResult result = test::sonoskin(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::json::parse(result.out);
  };
  EXPECT_FALSE(run("1", {}).contains("measures"));
  const std::string session =
      folder.write("face.sonoskin", sessionWith(kMeasures, test::fileText(folder / "1/recipe.json")))
          .string();
  const nlohmann::json same = run("2", {"--recipe", session}),
                       other = run("3", {"--recipe", session, "--phantom.seed", "7"});
  EXPECT_EQ(same["measures"], nlohmann::json::parse(measuresJson(kMeasures)));
  EXPECT_FALSE(other.contains("measures"));
  EXPECT_NE(other["warnings"].dump().find("measures of the session"), std::string::npos) << other["warnings"];
}

}  // namespace
}  // namespace sonoskin
