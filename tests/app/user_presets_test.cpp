#include "app/workspace/user_presets.h"

#include <gtest/gtest.h>

#include "core/pipeline/presets.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

TEST(UserPresets, AreKeptUnderTheirNames) {
  const test::TempFolder folder;
  Parameters soft, sharp;
  soft.classification.beta = 2;
  soft.mesh.partsDrop = {{1, 2, 3}};
  soft.landmarks.noseTip = {1, 2, 3};
  sharp.reconstruction.smoothness = 3e-6;
  std::vector<UserPreset> presets;
  keepPreset(presets, "Soft \"skin\" é", soft);
  keepPreset(presets, "Edges", sharp);
  keepPreset(presets, "Edges", soft);
  keepPreset(presets, "Edges", sharp);
  ASSERT_EQ(presets.size(), 2u);
  writeUserPresets(folder / "presets.json", presets);
  const std::vector<UserPreset> read = readUserPresets(folder / "presets.json");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].name, "Edges");
  EXPECT_EQ(read[1].name, "Soft \"skin\" é");

  Parameters now;
  now.mesh.partsAdd = {{4, 5, 6}};
  now.skin.melanin = 0.02;
  EXPECT_EQ(matchingUserPreset(read, now), nullptr);
  applyUserPreset(read[1], now);
  EXPECT_EQ(now.classification.beta, 2);
  EXPECT_EQ(now.mesh.partsAdd.size(), 1u) << "parts belong to a face";
  EXPECT_TRUE(now.mesh.partsDrop.empty());
  EXPECT_EQ(now.skin.melanin, 0.02);
  EXPECT_EQ(matchingUserPreset(read, now), &read[1]);
}

TEST(UserPresets, DamagedOnesAreLeftOut) {
  const test::TempFolder folder;
  EXPECT_TRUE(readUserPresets(folder / "none.json").empty());
  EXPECT_TRUE(readUserPresets(folder.write("a.json", "[1, 2")).empty());
  const auto read = readUserPresets(folder.write(
      "b.json",
      R"({"good": {"classification": {"beta": 2}}, "bad": {"classification": {"beta": "x"}}, "odd": 3})"));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].name, "good");
}

}  // namespace
}  // namespace sonoskin
