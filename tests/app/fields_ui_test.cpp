#include "app/widgets/fields_ui.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "core/classification/classification_options.h"
#include "core/pipeline/parameters.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

// FieldsUi: an interface without a window and without OpenGL.
class FieldsUi : public ImGuiTest {
 protected:
  FieldsUi() : ImGuiTest({600, 3000}) {}
  void SetUp() override {
    ImGuiTest::SetUp();
    frame();
    frame();
  }

  FieldsEdit frame() {
    beginFrame();
    FieldsEdit edit;
    groups(
        [&](const Group& group, auto& options) {
          if (!beginFields(std::string(group.name).c_str())) return;
          edit |= editFields(group.name, options);
          endFields();
        },
        parameters);
    ImGui::End();
    ImGui::Render();
    return edit;
  }
  void moveTo(const std::string& name, float share) {
    const auto& [min, max] = rects.byName.at(name);
    ImGui::GetIO().MousePos = {min.x + share * (max.x - min.x), 0.5f * (min.y + max.y)};
  }
  FieldsEdit press(int button, bool down) {
    ImGui::GetIO().MouseDown[button] = down;
    return frame();
  }

  Parameters parameters;
};

TEST_F(FieldsUi, ARowForEveryField) {
  forEachField(
      [&](const Group& group, const Field& field, auto&, auto...) {
        const std::string id = std::string(group.name) + "." + std::string(field.name);
        EXPECT_TRUE(rects.byName.contains(id)) << id;
      },
      parameters);
}

TEST_F(FieldsUi, SliderFollowsTheMouseAndIsAStepWhenLetGo) {
  moveTo("classification.beta", 0.25f);
  frame();
  press(0, true);
  moveTo("classification.beta", 0.75f);
  const FieldsEdit moving = frame();
  EXPECT_TRUE(moving.changed);
  EXPECT_FALSE(moving.finished);
  EXPECT_NEAR(parameters.classification.beta, 3, 0.2);
  EXPECT_TRUE(press(0, false).finished);
}

TEST_F(FieldsUi, LogarithmicSliderReachesBothEndsOfSmallRanges) {
  moveTo("reconstruction.smoothness", 0.5f);
  frame();
  press(0, true);
  frame();
  EXPECT_NEAR(parameters.reconstruction.smoothness, std::sqrt(1e-6 * 1e-3), 4e-6);
  moveTo("reconstruction.smoothness", -1);
  frame();
  EXPECT_DOUBLE_EQ(parameters.reconstruction.smoothness, 1e-6);
  moveTo("reconstruction.smoothness", 2);
  frame();
  EXPECT_DOUBLE_EQ(parameters.reconstruction.smoothness, 1e-3);
  press(0, false);
}

TEST_F(FieldsUi, RightButtonBringsTheDefaultBack) {
  parameters.classification.alpha = 3;
  moveTo("classification.alpha", 0.5f);
  frame();
  EXPECT_TRUE(press(1, true).finished);
  press(1, false);
  EXPECT_DOUBLE_EQ(parameters.classification.alpha, ClassificationOptions().alpha);
}

TEST_F(FieldsUi, NothingChangesWithoutTheMouse) {
  parameters.classification.alpha = 0.0123456;  // not a number that a slider would choose
  const FieldsEdit edit = frame();
  EXPECT_FALSE(edit.changed || edit.finished);
  EXPECT_DOUBLE_EQ(parameters.classification.alpha, 0.0123456);
}

TEST(FieldText, LabelsAndNumbers) {
  EXPECT_EQ(fieldLabel({"tangentialLength", ""}), "Tangential length");
  EXPECT_EQ(fieldLabel({"alpha", ""}), "Alpha");
  EXPECT_EQ(greekSymbol("alpha"), "α");
  EXPECT_EQ(greekSymbol("v_iso"), "v_iso");
  EXPECT_EQ(fieldNumber(5e-5, {1e-6, 1e-3, true}), "5.00e-05");
  EXPECT_EQ(fieldNumber(1, {0.01, 4, true}), "1.00");
  EXPECT_EQ(fieldNumber(2.25, {0, 4}), "2.25");
  EXPECT_EQ(fieldNumber(20, {0, 60}), "20.0");
  EXPECT_DOUBLE_EQ(roundedForSlider(0.123456), 0.123);
  EXPECT_DOUBLE_EQ(roundedForSlider(0), 0);
}

}  // namespace
}  // namespace sonoskin::ui
