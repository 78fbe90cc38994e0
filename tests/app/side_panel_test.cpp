// The panels of parameters, one below the other, without a window and without OpenGL.
#include <gtest/gtest.h>
#include <imgui.h>

#include <string>
#include <vector>

#include "app/panels/panels.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

class SidePanel : public ImGuiTest {
 protected:
  SidePanel() : ImGuiTest({400, 6000}) {}
  void SetUp() override {
    ImGuiTest::SetUp();
    frames(2);
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      rects.byName.clear();
      beginFrame();
      drawRegionPanel(workspace);
      drawClassificationPanel(workspace);
      drawReconstructionPanel(workspace);
      drawMorePanel(workspace);
      ImGui::End();
      ImGui::Render();
    }
  }
  void click(const std::string& name) {
    const auto found = rects.byName.find(name);
    ASSERT_NE(found, rects.byName.end()) << name;
    const auto& [min, max] = found->second;
    ImGui::GetIO().MousePos = {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)};
    frames(2);
    for (const bool down : {true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      frames(2);
    }
  }
  void openAll() {
    std::vector<std::string> names;
    for (const auto& [name, rect] : rects.byName)
      if (name.starts_with("foldout.") && name != "foldout.Crop box") names.push_back(name);
    for (const std::string& name : names) click(name);
  }
  // rows: how many parameters of the group are there, of how many.
  std::pair<int, int> rows(std::string_view group) const {
    int there = 0, all = 0;
    forEachField(
        [&](const Group& g, const Field& field, auto&, auto...) {
          if (g.name != group) return;
          ++all;
          there += rects.byName.contains(std::string(group) + "." + std::string(field.name));
        },
        parameters);
    return {there, all};
  }

  Workspace workspace{Parameters{}};
  const Parameters parameters{};
};

TEST_F(SidePanel, ShowsFewParametersAtFirst) {
  EXPECT_TRUE(rects.byName.contains("reconstruction.smoothness"));
  EXPECT_EQ(rows("reconstruction").first, 1);
  for (const char* group : {"mesh", "print", "surface", "scan", "global"}) EXPECT_EQ(rows(group).first, 0);
}

TEST_F(SidePanel, HasARowForEveryParameter) {
  openAll();
  groups(
      [&](const Group& group, auto&) {
        for (const char* elsewhere : {"raw", "region", "global", "skin", "light", "landmarks"})
          if (group.name == elsewhere) return;
        EXPECT_GT(rows(group.name).second, 0) << group.name;
        EXPECT_EQ(rows(group.name).first, rows(group.name).second) << group.name;
      },
      parameters);
  EXPECT_EQ(rows("global").first, 0) << "only for the global method";
  Parameters global;
  global.reconstruction.method = ReconstructionMethod::global;
  workspace.session.edit(global);
  frames(2);
  EXPECT_EQ(rows("global").first, rows("global").second);
}

// Two headings are called "Advanced": each opens its own.
TEST_F(SidePanel, HeadingsOfTheSameNameOpenOneAtATime) {
  click("foldout.Advanced##surface");
  EXPECT_EQ(rows("mesh").first, rows("mesh").second);
  EXPECT_LT(rows("classification").first, rows("classification").second);
}

// The same heading twice would be two lists of the same parameters.
TEST_F(SidePanel, NoGroupIsListedTwice) {
  for (const char* heading :
       {"foldout.Reconstruction", "foldout.Mesh", "foldout.Print", "foldout.Global", "foldout.Classification",
        "foldout.Region", "foldout.Skin", "foldout.Light", "foldout.Landmarks"})
    EXPECT_FALSE(rects.byName.contains(heading)) << heading;
  for (const char* heading : {"foldout.Scan", "foldout.Surface", "foldout.Phantom"})
    EXPECT_TRUE(rects.byName.contains(heading)) << heading;
}

}  // namespace
}  // namespace sonoskin::ui
