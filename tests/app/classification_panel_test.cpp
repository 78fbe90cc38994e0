// The panel of the classification without a window and without OpenGL.
#include <gtest/gtest.h>
#include <imgui.h>

#include "app/panels/panels.h"
#include "app/panels/preset_row.h"
#include "core/pipeline/parameter_use.h"
#include "core/pipeline/presets.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

class ClassificationPanel : public ImGuiTest {
 protected:
  ClassificationPanel() : ImGuiTest({400, 2000}) {}
  void SetUp() override {
    ImGuiTest::SetUp();
    frames(2);
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      beginFrame();
      drawClassificationPanel(workspace);
      ImGui::End();
      ImGui::Render();
    }
  }
  void moveTo(const std::string& name, float share = 0.5f) {
    const auto found = rects.byName.find(name);
    ASSERT_NE(found, rects.byName.end()) << name;
    const auto& [min, max] = found->second;
    ImGui::GetIO().MousePos = {min.x + share * (max.x - min.x), 0.5f * (min.y + max.y)};
    frames(2);
  }
  void click(const std::string& name, float share = 0.5f) {
    moveTo(name, share);
    for (const bool down : {true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      frames(2);
    }
  }
  const Parameters& parameters() { return workspace.session.parameters(); }

  Workspace workspace{Parameters{}};
};

TEST_F(ClassificationPanel, HasARowForEveryField) {
  ClassificationOptions options;
  fields(
      [&](const Field& field, auto&, auto...) {
        EXPECT_TRUE(rects.byName.contains("classification." + std::string(field.name))) << field.name;
      },
      options);
}

TEST_F(ClassificationPanel, APresetIsOneStepThatUndoTakesBack) {
  Parameters own = parameters();
  own.classification.gamma = 1.7;
  workspace.session.edit(own);
  workspace.session.commitEdit();
  click("preset");
  click("preset.smooth");
  ASSERT_NE(matchingPreset(parameters()), nullptr);
  EXPECT_EQ(matchingPreset(parameters())->name, "smooth");
  workspace.session.undo();
  EXPECT_EQ(parameters().classification.gamma, 1.7);
  EXPECT_EQ(matchingPreset(parameters()), nullptr);
  workspace.session.redo();
  EXPECT_EQ(matchingPreset(parameters())->name, "smooth");
}

TEST_F(ClassificationPanel, WhatHasNoEffectCannotBeMoved) {
  click("preset");
  click("preset.thesis-baby-2");
  const double beta = parameters().classification.beta;
  click("classification.beta", 0.9f);
  EXPECT_EQ(parameters().classification.beta, beta);
  click("classification.isoValue", 0.5f);
  EXPECT_NEAR(parameters().classification.isoValue, 0.5, 0.05);
}

TEST_F(ClassificationPanel, TheAutomaticIsoValueStaysAutomaticUntilItIsMoved) {
  frames(5);
  moveTo("classification.isoValue", 0.3f);
  EXPECT_EQ(parameters().classification.isoValue, 0);
  EXPECT_FALSE(workspace.session.canUndo());
  click("classification.isoValue", 0.3f);
  EXPECT_NEAR(parameters().classification.isoValue, 0.3, 0.05);
}

TEST(PresetRow, TitlesAreForPeople) {
  EXPECT_EQ(presetTitle("default"), "Default");
  EXPECT_EQ(presetTitle("thesis-baby-1"), "Thesis baby 1");
}

}  // namespace
}  // namespace sonoskin::ui
