#include "app/views/layouts.h"

#include "app/workspace/commands.h"
#include "app/workspace/settings.h"
#include "app/workspace/workspace.h"
#include "tests/support/imgui_test.h"
#include "tests/support/temp_folder.h"

namespace sonoskin::ui {
namespace {

class Layouts : public ImGuiTest {
 protected:
  Layouts() : ImGuiTest({800, 600}) {}

  // One frame with the mouse somewhere, its button down or up.
  void frame(ImVec2 mouse, bool down) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = mouse;
    io.MouseDown[ImGuiMouseButton_Left] = down;
    beginFrame();
    drawDividers(layout, corner, area);
    ImGui::End();
    ImGui::Render();
  }

  const ImVec2 corner{20, 10}, area{760, 580};
  LayoutState layout;
};

TEST_F(Layouts, CellsFillTheAreaAndDoNotOverlap) {
  for (const float share : {0.15f, 0.5f, 0.7f})
    for (const Layout kind : {Layout::fourUp, Layout::compare, Layout::casts, Layout::oblique}) {
      layout = {kind, share, 1 - share, Plane::coronal};
      const Cells cells = cellsOf(layout, corner, area);
      const float gap = cells[1].corner.x - cells[0].corner.x - cells[0].size.x;
      EXPECT_GT(gap, 2);
      EXPECT_LT(gap, 8);
      EXPECT_FLOAT_EQ(cells[0].size.x + gap + cells[1].size.x, area.x);
      EXPECT_FLOAT_EQ(cells[0].size.y + gap + cells[2].size.y, area.y);
      EXPECT_FLOAT_EQ(cells.back().corner.x + cells.back().size.x, corner.x + area.x);
      EXPECT_FLOAT_EQ(cells.back().corner.y + cells.back().size.y, corner.y + area.y);
      for (std::size_t n = 3; n < cells.size(); ++n)
        EXPECT_NEAR(cells[n].corner.x - cells[n - 1].corner.x - cells[n - 1].size.x, gap, 1e-3);
      EXPECT_NEAR(cells[0].size.x / area.x, share, 0.01);
    }
}

TEST_F(Layouts, WhatIsComparedIsOneSliceInAllLayers) {
  layout = {Layout::compare, 0.5f, 0.5f, Plane::sagittal};
  const Cells cells = cellsOf(layout, corner, area);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_EQ(cells[n].plane, Plane::sagittal);
    EXPECT_EQ(cells[n].layer, SliceLayer(n));
  }
  EXPECT_EQ(cells[3].pane, Pane::space);
}

TEST_F(Layouts, RayCastsThatAreComparedLieBesideTheSurface) {
  layout = {Layout::casts, 0.5f, 0.5f, Plane::axial};
  const Cells cells = cellsOf(layout, corner, area);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_TRUE(cells[n].cast);
    EXPECT_EQ(cells[n].layer, SliceLayer(n));
  }
  EXPECT_EQ(cells[3].pane, Pane::space);
  EXPECT_FALSE(cells[3].cast);
}

TEST_F(Layouts, AnObliqueSliceLiesAboveTheThreePlanes) {
  layout = {Layout::oblique, 0.5f, 0.5f, Plane::axial};
  const Cells cells = cellsOf(layout, corner, area);
  ASSERT_EQ(cells.size(), 5u);
  EXPECT_EQ(cells[0].pane, Pane::oblique);
  EXPECT_FALSE(cells[0].plane);
  EXPECT_EQ(cells[1].pane, Pane::space);
  EXPECT_EQ(cells[4].plane, Plane::sagittal);
}

TEST_F(Layouts, DividersFollowTheMouseAndADoubleClickBringsThemBack) {
  frame({0, 0}, false);
  const auto middle = [&](const char* id) {
    const auto [min, max] = rects.byName.at(id);
    return ImVec2{0.5f * (min.x + max.x), min.y + 0.25f * (max.y - min.y)};
  };
  const ImVec2 at = middle("divider.across");
  frame(at, false);
  frame(at, true);
  frame({at.x + 100, at.y}, true);
  frame({at.x + 152, at.y}, true);
  frame({at.x + 152, at.y}, false);
  EXPECT_NEAR(layout.across, 0.7f, 0.01f);
  EXPECT_EQ(layout.down, 0.5f);
  frame({at.x + 152, at.y}, true);
  frame({2000, at.y}, true);
  frame({2000, at.y}, false);
  EXPECT_EQ(layout.across, kMostShare) << "each view keeps some room";
  for (int n = 0; n < 100; ++n) frame({0, 0}, false);  // no second of two clicks
  const ImVec2 moved = middle("divider.across");
  frame(moved, false);
  for (const bool down : {true, false, true, false}) frame(moved, down);
  EXPECT_EQ(layout.across, 0.5f);
}

TEST(LayoutSettings, AreRemembered) {
  const test::TempFolder folder;
  Settings settings;
  settings.layout = {Layout::compare, 0.25f, 0.75f, Plane::coronal};
  writeSettings(folder / "settings.json", settings);
  const LayoutState read = readSettings(folder / "settings.json").layout;
  EXPECT_EQ(read.layout, Layout::compare);
  EXPECT_FLOAT_EQ(read.across, 0.25f);
  EXPECT_FLOAT_EQ(read.down, 0.75f);
  EXPECT_EQ(read.compared, Plane::coronal);
  folder.write("other.json", R"({"layout": "none", "dividerAcross": 1e300, "comparedPlane": "oblique"})");
  const LayoutState odd = readSettings(folder / "other.json").layout;
  EXPECT_EQ(odd.layout, Layout::fourUp);
  EXPECT_EQ(odd.across, kMostShare);
  EXPECT_EQ(odd.compared, Plane::axial);
}

TEST(LayoutCommands, HaveTheirKeys) {
  Workspace workspace{Parameters()};
  command("layout.compare").run(workspace);
  EXPECT_EQ(workspace.settings.layout.layout, Layout::compare);
  EXPECT_EQ(shortcutText(command("layout.fourUp").shortcut), "F2");
  EXPECT_EQ(shortcutText(command("layout.comparePlane").shortcut), "Shift+F3");
  command("layout.casts").run(workspace);
  EXPECT_EQ(workspace.settings.layout.layout, Layout::casts);
  EXPECT_FALSE(isEnabled(command("layout.comparePlane"), workspace)) << "no slice is compared";
  command("layout.fourUp").run(workspace);
  EXPECT_EQ(workspace.settings.layout.layout, Layout::fourUp);
}

}  // namespace
}  // namespace sonoskin::ui
