// The skin panel without a window and without OpenGL.
#include <gtest/gtest.h>
#include <imgui.h>

#include <set>

#include "app/panels/panels.h"
#include "app/panels/skin_rows.h"
#include "app/workspace/skin_looks.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

class SkinPanel : public ImGuiTest {
 protected:
  SkinPanel() : ImGuiTest({400, 3000}) {}
  void SetUp() override {
    ImGuiTest::SetUp();
    workspace.view.content = SpaceContent::mesh;
    workspace.view.meshStyle = MeshStyle::skin;
    // Panels are enabled once there is a mesh.
    workspace.session.openPhantom();
    while (!workspace.session.hasScan()) workspace.session.poll();
    workspace.session.reconstruct();
    while (!workspace.session.results().mesh) workspace.session.poll();
    frames(2);
  }
  static Parameters small() {
    Parameters p;
    p.phantom.dims = {78, 43, 31};
    p.mesh.resolution = 60;
    p.surface.minClusterArea = 20;
    return p;
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      rects.byName.clear();
      beginFrame();
      drawSkinPanel(workspace);
      ImGui::End();
      ImGui::Render();
    }
  }
  void press(const std::string& name, float x = 0.5f) {
    const auto found = rects.byName.find(name);
    ASSERT_NE(found, rects.byName.end()) << name;
    const auto& [min, max] = found->second;
    ImGui::GetIO().MousePos = {min.x + x * (max.x - min.x), 0.5f * (min.y + max.y)};
    frames(2);
    for (const bool down : {true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      frames(2);
    }
  }
  bool has(const std::string& name) const { return rects.byName.contains(name); }

  Workspace workspace{small()};
};

// Its rows stay where the view shows something else, and a button shows what they change.
TEST_F(SkinPanel, ShowsSkinWhereTheViewDoesNot) {
  EXPECT_TRUE(has("skin.wetness"));
  workspace.view.content = SpaceContent::volume;
  frames(2);
  EXPECT_TRUE(has("skin.wetness"));
  press("skin.show");
  EXPECT_EQ(workspace.view.content, SpaceContent::mesh);
  EXPECT_EQ(workspace.view.meshStyle, MeshStyle::skin);
}

TEST_F(SkinPanel, HasARowForEveryParameter) {
  for (const char* heading : {"Pigments", "Scattering", "More light", "Landmarks"})
    press(std::string("foldout.") + heading);
  const Parameters parameters;
  forEachField(
      [&](const Group& group, const Field& field, auto&, auto...) {
        if (group.name != "skin" && group.name != "light") return;
        EXPECT_TRUE(has(std::string(group.name) + "." + std::string(field.name))) << field.name;
      },
      parameters);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(has("landmark." + std::to_string(i)));
}

TEST_F(SkinPanel, ASliderIsOneStepForUndo) {
  const double before = workspace.session.parameters().skin.wetness;
  press("skin.wetness", 0.8f);
  EXPECT_GT(workspace.session.parameters().skin.wetness, 0.6);
  ASSERT_TRUE(workspace.session.canUndo());
  workspace.session.undo();
  EXPECT_EQ(workspace.session.parameters().skin.wetness, before);
}

TEST_F(SkinPanel, ChoosesALook) {
  press("look");
  const SkinPreset& last = skinPresets().back();
  press("look." + std::string(last.name));
  EXPECT_EQ(matchingSkinPreset(workspace.session.parameters().skin, workspace.session.parameters().light),
            &last);
  EXPECT_EQ(lookOf(workspace.session.parameters()).preset, &last);
  EXPECT_TRUE(workspace.session.canUndo());
  Parameters p = workspace.session.parameters();
  p.light.azimuth += 10;
  EXPECT_EQ(lookOf(p).preset, &last);
  EXPECT_TRUE(lookOf(p).otherLight);
  p.skin.wetness = 0.123;
  EXPECT_EQ(lookOf(p).preset, nullptr);
}

TEST_F(SkinPanel, ShowsPasses) {
  press("skin.pass");
  press("skin.pass.irradiance");
  EXPECT_EQ(workspace.view.skin.pass, SkinPass::irradiance);
  std::set<std::string> titles;
  for (std::size_t i = 0; i < enumNames(SkinPass{}).size(); ++i)
    EXPECT_TRUE(titles.insert(passTitle(SkinPass(i))).second) << "every pass has words of its own";
}

TEST_F(SkinPanel, KeepsSettingsToCompare) {
  press("skin.compare.A | B");
  EXPECT_EQ(workspace.view.skin.compare, SkinCompare::settings);
  ASSERT_TRUE(workspace.view.skin.kept);
  const SkinOptions first = workspace.view.skin.kept->skin;
  press("skin.wetness", 0.9f);
  EXPECT_EQ(workspace.view.skin.kept->skin, first);
  press("skin.keep");
  EXPECT_EQ(workspace.view.skin.kept->skin, workspace.session.parameters().skin);
}

TEST_F(SkinPanel, PlacesAndClearsLandmarks) {
  press("foldout.Landmarks");
  ASSERT_TRUE(isSet(workspace.session.parameters().landmarks.noseTip)) << "the phantom's own";
  press("landmark.2");
  EXPECT_EQ(workspace.view.spaceTool, Tool::landmark);
  EXPECT_EQ(workspace.view.landmark, std::size_t(2));
  press("landmark.2");
  EXPECT_EQ(workspace.view.spaceTool, Tool::crossHair);
  press("landmark.2.clear");
  EXPECT_FALSE(isSet(workspace.session.parameters().landmarks.noseTip));
  workspace.session.undo();
  EXPECT_TRUE(isSet(workspace.session.parameters().landmarks.noseTip));
}

TEST_F(SkinPanel, ChoosesTheQuality) {
  press("skin.quality.Full");
  EXPECT_EQ(workspace.settings.skinQuality, SkinQualityChoice::full);
  press("skin.quality.Auto");
  EXPECT_EQ(workspace.settings.skinQuality, SkinQualityChoice::automatic);
}

TEST_F(SkinPanel, OpenHeadingsShowTheirMarksInTheView) {
  EXPECT_FALSE(workspace.view.skin.reach || workspace.view.skin.places);
  press("foldout.Scattering");
  press("foldout.Landmarks");
  EXPECT_TRUE(workspace.view.skin.reach && workspace.view.skin.places);
}

}  // namespace
}  // namespace sonoskin::ui
