#include "app/widgets/fields_ui.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "app/widgets/field_equations.h"
#include "app/widgets/number_row.h"
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

TEST_F(FieldsUi, TheNumberLiesBesideTheTrack) {
  const auto &track = rects.byName.at("classification.beta"),
             &number = rects.byName.at("classification.beta.number");
  EXPECT_GE(number.min.x, track.max.x);
  EXPECT_EQ(number.min.y, track.min.y);
}

TEST_F(FieldsUi, AClickOnTheNumberLetsOneTypeIt) {
  const auto before = rects.byName.at("classification.gamma.number");
  moveTo("classification.gamma.number", 0.5f);
  frame();
  press(0, true);
  press(0, false);
  frame();
  frame();
  EXPECT_EQ(rects.byName.at("classification.gamma.number").min.x, before.min.x) << "it has moved";
  EXPECT_EQ(rects.byName.at("classification.gamma.number").max.x, before.max.x);
  for (const char c : std::string("1,75")) ImGui::GetIO().AddInputCharacter(unsigned(c));
  FieldsEdit edit = frame();
  EXPECT_FALSE(edit.changed) << "what is half typed";
  ImGuiIO& io = ImGui::GetIO();
  io.KeyMap[ImGuiKey_Enter] = 1;
  io.KeysDown[1] = true;
  edit = frame();
  io.KeysDown[1] = false;
  edit |= frame();
  EXPECT_TRUE(edit.changed && edit.finished);
  EXPECT_DOUBLE_EQ(parameters.classification.gamma, 1.75);
}

TEST_F(FieldsUi, TheButtonOfTheDefaultHasItsPlaceAndComesWhenItIsNeeded) {
  EXPECT_FALSE(rects.byName.contains("classification.alpha.reset"));
  const auto before = rects.byName.at("classification.alpha.number");
  parameters.classification.alpha = 3;
  frame();
  ASSERT_TRUE(rects.byName.contains("classification.alpha.reset"));
  EXPECT_EQ(rects.byName.at("classification.alpha.number").max.x, before.max.x);
  moveTo("classification.alpha.reset", 0.5f);
  frame();
  press(0, true);
  EXPECT_TRUE(press(0, false).finished);
  EXPECT_DOUBLE_EQ(parameters.classification.alpha, ClassificationOptions().alpha);
}

TEST_F(FieldsUi, NothingChangesWithoutTheMouse) {
  parameters.classification.alpha = 0.0123456;  // not a number that a slider would choose
  const FieldsEdit edit = frame();
  EXPECT_FALSE(edit.changed || edit.finished);
  EXPECT_DOUBLE_EQ(parameters.classification.alpha, 0.0123456);
}

TEST(FieldText, WhatIsTypedIsANumber) {
  EXPECT_EQ(numberTyped("1.5"), 1.5);
  EXPECT_EQ(numberTyped(" 1,5 mm"), 1.5);
  EXPECT_EQ(numberTyped("+2e-3"), 2e-3);
  for (const char* none : {"", "mm", "inf", "nan", "--1"}) EXPECT_FALSE(numberTyped(none)) << none;
}

// The classification's numbers stand in what it solves, and no equation is without its parameter.
TEST(FieldText, ParametersWithSymbolsHaveTheirEquations) {
  ClassificationOptions options;
  std::size_t count = 0;
  fields(
      [&](const Field& field, auto&, auto...) {
        const std::string equation = equationOf("classification." + std::string(field.name));
        EXPECT_EQ(equation.empty(), field.symbol.empty()) << field.name;
        if (field.symbol.size() > 0 && field.name != "farthest") {
          EXPECT_NE(equation.find(greekSymbol(field.symbol)), std::string_view::npos) << field.name;
          ++count;
        }
      },
      options);
  EXPECT_GE(count, 12u);
  for (const char* name : {"alpha", "beta", "gamma"})
    EXPECT_TRUE(equationOf(std::string("classification.") + name).starts_with("E(u) = "));
  EXPECT_TRUE(equationOf("classification.nothing").empty());
}

TEST(FieldText, LabelsAndNumbers) {
  EXPECT_EQ(fieldLabel({"tangentialLength", ""}), "Tangential length");
  EXPECT_EQ(fieldLabel({"alpha", ""}), "Suppression") << "what it is called in its row";
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
