#include "render/transfer_presets.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

// All of them are transparent below the skin and rise from there, wherever it is.
TEST(TransferPresets, FollowTheSkin) {
  for (const TransferPreset& preset : transferPresets())
    for (const float iso : {0.05f, 0.2f, 0.5f, 0.9f}) {
      const TransferFunction transfer = preset.at(iso);
      SCOPED_TRACE(preset.name);
      EXPECT_EQ(transfer.at(0.5f * iso).a, 0);
      EXPECT_GT(transfer.threshold(), 0.4f * iso);
      EXPECT_LE(transfer.threshold(), iso);
      float before = 0;
      for (const auto& point : transfer.points) {
        EXPECT_GE(point.value, before);
        EXPECT_LE(point.value, 1);
        before = point.value;
      }
      EXPECT_GT(transfer.at(1).a, 0.5f);
    }
  EXPECT_STREQ(findTransferPreset("bone")->name, "bone");
  EXPECT_EQ(findTransferPreset("steel"), nullptr);
}

TEST(TransferPresets, WhatWasMadeForOneScanMovesWithAnother) {
  const LevelledTransfer made{{{{0.2f, glm::vec3(1), 0}, {0.4f, glm::vec3(1), 0.5f}, {1, glm::vec3(1), 1}}},
                              0.3f};
  EXPECT_FLOAT_EQ(made.at(0.3f).at(0.35f).a, made.function.at(0.35f).a);
  EXPECT_FLOAT_EQ(made.at(0.5f).at(0.6f).a, 0.5f);
  EXPECT_FLOAT_EQ(made.at(0).points.front().value, 0);  // and stays within 0 to 1
}

}  // namespace
}  // namespace sonoskin
