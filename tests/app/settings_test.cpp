#include "app/workspace/settings.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

// A cast of the second number to int is undefined; it gave the least width.
TEST(Settings, SizesThatNoScreenHasBecomeTheNearestOnes) {
  const test::TempFolder folder;
  folder.write("settings.json", R"({"width": 4294967297, "height": 5.5e35})");
  const Settings read = readSettings(folder / "settings.json");
  EXPECT_EQ(read.width, 8192);
  EXPECT_EQ(read.height, 8192);
}

TEST(Settings, ThemeAndScaleAreKept) {
  const test::TempFolder folder;
  Settings settings;
  EXPECT_EQ(settings.appearance, Appearance::dark);
  EXPECT_EQ(settings.scale, 0) << "as the screen has it";
  settings.appearance = Appearance::light;
  settings.scale = 1.75;
  writeSettings(folder / "settings.json", settings);
  const Settings read = readSettings(folder / "settings.json");
  EXPECT_EQ(read.appearance, Appearance::light);
  EXPECT_EQ(read.scale, 1.75);
  folder.write("settings.json", R"({"scale": 40, "appearance": "pink"})");
  EXPECT_EQ(readSettings(folder / "settings.json").scale, kMostScale);
  EXPECT_EQ(readSettings(folder / "settings.json").appearance, Appearance::dark);
  folder.write("settings.json", R"({"scale": -1})");
  EXPECT_EQ(readSettings(folder / "settings.json").scale, 0);
}

// Whoever wants no file to be remembered is not to be remembered for a slip in another line.
TEST(Settings, OneDamagedValueSpoilsNoOther) {
  const test::TempFolder folder;
  folder.write("settings.json",
               R"({"folder": "/scans", "recent": ["/scans/a.nrrd", 7], "remembersFiles": false,
                                    "width": "wide", "tourOffered": 1, "layout": [], "scale": 2})");
  const Settings read = readSettings(folder / "settings.json");
  EXPECT_EQ(read.folder, "/scans");
  ASSERT_EQ(read.recent.size(), 1u);
  EXPECT_EQ(read.recent[0], "/scans/a.nrrd");
  EXPECT_FALSE(read.remembersFiles);
  EXPECT_FALSE(read.tourOffered);
  EXPECT_EQ(read.width, Settings{}.width);
  EXPECT_EQ(read.scale, 2);
}

TEST(Settings, AFileThatIsNoJsonIsSetAsideAndNothingRemembered) {
  const test::TempFolder folder;
  EXPECT_TRUE(readSettings(folder / "settings.json").remembersFiles) << "there is none yet";
  folder.write("settings.json", R"({"remembersFiles": fal)");
  EXPECT_FALSE(readSettings(folder / "settings.json").remembersFiles);
  EXPECT_FALSE(std::filesystem::exists(folder / "settings.json"));
  EXPECT_TRUE(std::filesystem::exists(folder / "settings.json.damaged"));
}

}  // namespace
}  // namespace sonoskin
