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

}  // namespace
}  // namespace sonoskin
