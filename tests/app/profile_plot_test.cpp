#include "app/widgets/profile_plot.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "app/widgets/plot_area.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

class ProfilePlotTest : public ImGuiTest {
 protected:
  ProfilePlotTest() : ImGuiTest({320, 700}) {}
  void frame() {
    beginFrame();
    drawProfilePlot(plot, options);
    ImGui::End();
    ImGui::Render();
  }
  bool has(const char* name) { return rects.byName.contains(name); }

  SkinOptions options;
  ProfilePlot plot;
};

TEST_F(ProfilePlotTest, LiteratureHasNoError) {
  frame();
  EXPECT_TRUE(has("profile.curves") && has("profile.radii") && has("profile.weights"));
  EXPECT_FALSE(has("profile.error"));
}

TEST_F(ProfilePlotTest, FollowsTheOptions) {
  options.profile = ScatterProfile::custom;
  options.gaussians = 2;
  frame();
  EXPECT_TRUE(has("profile.error"));
  EXPECT_EQ(plot.curves.sum.weights[3], glm::dvec3(0));
  const double before = radiusOfEnergy(plot.curves.sum, 0, 0.5);
  options.width = 2;
  frame();
  EXPECT_NEAR(radiusOfEnergy(plot.curves.sum, 0, 0.5), 2 * before, 1e-6);
}

TEST_F(ProfilePlotTest, SwitchChangesTheAxis) {
  frame();
  const auto& [min, max] = rects.byName.at("profile.logarithmic");
  ImGui::GetIO().MousePos = {min.x + 5, (min.y + max.y) / 2};
  frame();
  for (bool down : {true, false}) {
    ImGui::GetIO().MouseDown[0] = down;
    frame();
  }
  EXPECT_FALSE(plot.logarithmic);
}

// Whatever the options, every corner of what is drawn is a number inside the window.
TEST_F(ProfilePlotTest, StaysInsideTheWindow) {
  for (ScatterProfile profile : {ScatterProfile::adult, ScatterProfile::vernix, ScatterProfile::custom})
    for (double width : {0.0, 0.05, 1.0, 4.0})
      for (bool logarithmic : {false, true}) {
        options.profile = profile;
        options.width = width;
        plot.logarithmic = logarithmic;
        frame();
        const ImDrawData& data = *ImGui::GetDrawData();
        ASSERT_GT(data.TotalVtxCount, 2000);
        for (int n = 0; n < data.CmdListsCount; ++n)
          for (const ImDrawVert& vertex : data.CmdLists[n]->VtxBuffer) {
            ASSERT_TRUE(vertex.pos.x >= -2 && vertex.pos.x <= 322) << vertex.pos.x << " " << width;
            ASSERT_TRUE(std::isfinite(vertex.pos.y));
          }
      }
}

TEST(PlotArea, PutsValuesInPlace) {
  PlotArea area{{100, 10}, {300, 110}, 0, 10, 0, 4, false};
  EXPECT_EQ(area.at(5, 1).x, 200);
  EXPECT_EQ(area.at(5, 1).y, 85);
  EXPECT_EQ(area.at(20, -30).x, 300);
  EXPECT_EQ(area.at(20, -30).y, 160) << "far outside: half a height beyond the end";
  EXPECT_EQ(area.under(200), 5);
  area.logarithmic = true;
  area.low = 0.01, area.high = 1;
  EXPECT_NEAR(area.at(0, 0.1).y, 60, 1e-4);
  EXPECT_TRUE(std::isfinite(area.at(0, 0).y));
}

TEST(PlotArea, TicksAreRound) {
  EXPECT_DOUBLE_EQ(tickStep(10, 5), 2);
  EXPECT_DOUBLE_EQ(tickStep(0.7, 4), 0.2);
  EXPECT_DOUBLE_EQ(tickStep(36, 4), 10);
}

}  // namespace
}  // namespace sonoskin::ui
