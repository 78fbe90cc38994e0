// The editor of transfer functions under a mouse, without a window.
#include "app/widgets/transfer_editor.h"

#include "app/widgets/transfer_points.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

TransferFunction ramp() { return {{{0.2f, {1, 0, 0}, 0}, {0.5f, {0, 1, 0}, 0.25f}, {0.9f, {0, 0, 1}, 1}}}; }

TEST(TransferPoints, StayInOrder) {
  TransferFunction transfer = ramp();
  movePoint(transfer, 1, 0.95f, 2);
  EXPECT_FLOAT_EQ(transfer.points[1].value, 0.9f);
  EXPECT_FLOAT_EQ(transfer.points[1].opacity, 1);
  movePoint(transfer, 0, -1, -1);
  EXPECT_FLOAT_EQ(transfer.points[0].value, 0);
  const TransferFunction before = ramp();
  transfer = ramp();
  EXPECT_EQ(addPoint(transfer, 0.7f), 2);
  for (float value = 0; value < 1; value += 0.05f)
    EXPECT_LT(glm::length(transfer.at(value) - before.at(value)), 1e-5f);
  EXPECT_TRUE(removePoint(transfer, 2));
  EXPECT_TRUE(removePoint(transfer, 0));
  EXPECT_FALSE(removePoint(transfer, 0)) << "two are left";
  EXPECT_FALSE(removePoint(transfer, 7));
}

class TransferEditor : public ImGuiTest {
 protected:
  TransferEditor() : ImGuiTest({320, 240}) {}
  FieldsEdit frame() {
    beginFrame();
    const FieldsEdit made = editTransfer(transfer, {histogram, 0.3f}, selected);
    ImGui::End();
    ImGui::Render();
    return made;
  }
  void moveTo(const std::string& widget, glm::vec2 off = {0, 0}) {
    const auto& [min, max] = rects.byName.at(widget);
    ImGui::GetIO().MousePos = {0.5f * (min.x + max.x) + off.x, 0.5f * (min.y + max.y) + off.y};
    frame();
  }
  void button(int which, bool down) {
    ImGui::GetIO().MouseDown[which] = down;
    edit = frame();
  }

  TransferFunction transfer = ramp();
  std::vector<float> histogram = std::vector<float>(256, 0.3f);
  int selected = -1;
  FieldsEdit edit;
};

TEST_F(TransferEditor, DragsAddsAndTakesAway) {
  frame();
  moveTo("transfer.1");
  button(0, true);
  EXPECT_EQ(selected, 1);
  EXPECT_FALSE(edit.changed) << "a click selects";
  ImGui::GetIO().MousePos.x += 30;
  ImGui::GetIO().MousePos.y -= 20;
  EXPECT_TRUE(frame().changed);
  button(0, false);
  EXPECT_TRUE(edit.finished);
  EXPECT_GT(transfer.points[1].value, 0.55f);
  EXPECT_GT(transfer.points[1].opacity, 0.3f);
  EXPECT_EQ(transfer.points.size(), 3u);

  moveTo("transfer.2", {-30, 40});
  button(0, true);
  button(0, false);
  ASSERT_EQ(transfer.points.size(), 4u);
  EXPECT_EQ(selected, 2);
  EXPECT_LT(transfer.points[2].opacity, 0.5f) << "it lies where the mouse clicked, not on the curve";

  moveTo("transfer.2");
  button(1, true);
  button(1, false);
  EXPECT_EQ(transfer.points.size(), 3u);
  EXPECT_EQ(selected, -1);
}

}  // namespace
}  // namespace sonoskin::ui
