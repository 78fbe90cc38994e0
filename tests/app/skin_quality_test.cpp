#include "app/workspace/skin_quality.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using enum SkinQualityChoice;

TEST(SkinQuality, AFastMachineGetsFullQuality) {
  QualityChooser chooser;
  EXPECT_FALSE(chooser.full(automatic)) << "nothing is known yet";
  chooser.measured(false, {0.002, 0.004});
  EXPECT_TRUE(chooser.full(automatic));
  chooser.measured(true, {0.012, 0.030});
  EXPECT_TRUE(chooser.full(automatic));
}

TEST(SkinQuality, ASlowMachineKeepsLightQuality) {
  QualityChooser chooser;
  chooser.measured(false, {0.06, 0.15});
  EXPECT_FALSE(chooser.full(automatic));
  chooser.measured(false, {0.005, 0.15});
  EXPECT_FALSE(chooser.full(automatic)) << "a small view of slow light";
}

// It must not change to and fro.
TEST(SkinQuality, WhatWasTooSlowOnceIsNotTriedAgain) {
  QualityChooser chooser;
  chooser.measured(false, {0.004, 0.004});
  ASSERT_TRUE(chooser.full(automatic));
  chooser.measured(true, {0.05, 0.1});
  EXPECT_FALSE(chooser.full(automatic));
  chooser.measured(false, {0.004, 0.004});
  EXPECT_FALSE(chooser.full(automatic));
}

TEST(SkinQuality, ThePersonOverrules) {
  QualityChooser chooser;
  chooser.measured(true, {0.5, 3});
  EXPECT_TRUE(chooser.full(full));
  chooser.measured(true, {0.001, 0.001});
  EXPECT_FALSE(chooser.full(light));
}

TEST(SkinQuality, TheChoiceIsRemembered) {
  const test::TempFolder folder;
  Settings settings;
  EXPECT_EQ(readSettings(folder / "none.json").skinQuality, automatic);
  for (const SkinQualityChoice choice : {full, light, automatic}) {
    settings.skinQuality = choice;
    writeSettings(folder / "settings.json", settings);
    EXPECT_EQ(readSettings(folder / "settings.json").skinQuality, choice);
  }
  folder.write("settings.json", R"({"skinQuality": "enormous"})");
  EXPECT_EQ(readSettings(folder / "settings.json").skinQuality, automatic);
}

}  // namespace
}  // namespace sonoskin
