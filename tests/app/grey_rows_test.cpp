#include "app/panels/grey_rows.h"

#include "tests/app/session_support.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

class GreyRows : public ImGuiTest {
 protected:
  GreyRows() : ImGuiTest({300, 200}), workspace(test::tinyPhantom()) {}

  void frame(ImVec2 mouse, bool down) {
    ImGui::GetIO().MousePos = mouse;
    ImGui::GetIO().MouseDown[ImGuiMouseButton_Left] = down;
    beginFrame();
    drawGreyRows(workspace);
    ImGui::End();
    ImGui::Render();
  }
  void click(const char* widget) {
    frame({0, 0}, false);
    const auto [min, max] = rects.byName.at(widget);
    const ImVec2 at{0.5f * (min.x + max.x), 0.5f * (min.y + max.y)};
    for (const bool down : {false, true, false}) frame(at, down);
  }

  Workspace workspace;
};

// Ultrasound has no window in Hounsfield units.
TEST_F(GreyRows, SetTheWindowAndBringItBack) {
  workspace.session.openPhantom();
  ASSERT_TRUE(test::wait(workspace.session));
  click("slices.automatic");
  EXPECT_LT(workspace.view.grey.width, 1);
  click("slices.whole");
  EXPECT_EQ(workspace.view.grey.width, 1);
  EXPECT_FALSE(rects.byName.contains("slices.bone"));
}

}  // namespace
}  // namespace sonoskin::ui
