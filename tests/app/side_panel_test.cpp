// The side panel without a window and without OpenGL: the list of steps, the parameters of each, the work below.
#include <gtest/gtest.h>
#include <imgui.h>

#include <map>
#include <set>
#include <string>

#include "app/panels/panels.h"
#include "app/workspace/commands.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/app/session_support.h"
#include "tests/support/imgui_test.h"
#include "tests/support/temp_folder.h"

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
      place = drawSidePanel(workspace, {400, 6000});
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
  void open(Step step) {
    click(std::string("step.") + stepName(step));
    ASSERT_EQ(workspace.step, step);
  }
  void makeSurface() {
    workspace.session.openPhantom();
    ASSERT_TRUE(test::wait(workspace.session));
    workspace.session.reconstruct();
    ASSERT_TRUE(test::wait(workspace.session));
    ASSERT_TRUE(workspace.session.results().mesh);
  }
  Workspace workspace{test::tinySurface()};
  const Parameters parameters{};
  ToastPlace place{};
};

TEST_F(SidePanel, AClickOnAStepShowsItsParametersAlone) {
  const std::pair<Step, const char*> rowsOf[] = {{Step::volume, "scan.spacing"},
                                                 {Step::classify, "classification.isoValue"},
                                                 {Step::surface, "reconstruction.smoothness"},
                                                 {Step::skin, "skin.wetness"},
                                                 {Step::output, "print.form"}};
  for (const auto& [step, row] : rowsOf) {
    open(step);
    for (const auto& [other, otherRow] : rowsOf)
      EXPECT_EQ(rects.byName.contains(otherRow), other == step) << otherRow;
  }
}

TEST_F(SidePanel, EveryParameterIsInOneStep) {
  makeSurface();  // without one the skin's headings are closed
  std::set<std::string> seen;
  for (const Step step : kSteps) {
    open(step);
    const auto closed = rects.byName;
    for (const auto& [name, rect] : closed)
      if (name.starts_with("foldout.")) click(name);
    forEachField(
        [&](const Group& group, const Field& field, auto&, auto...) {
          const std::string id = std::string(group.name) + "." + std::string(field.name);
          if (rects.byName.contains(id)) {
            EXPECT_TRUE(seen.insert(id).second) << id << " is there twice";
          }
        },
        parameters);
  }
  forEachField(
      [&](const Group& group, const Field& field, auto&, auto...) {
        for (const char* elsewhere : {"raw", "region", "landmarks"})
          if (group.name == elsewhere) return;
        EXPECT_TRUE(seen.contains(std::string(group.name) + "." + std::string(field.name)))
            << group.name << "." << field.name;
      },
      parameters);
}

// What is solved lies together, at the top, each with its symbol beside it.
TEST_F(SidePanel, TheEquationsParametersComeFirst) {
  open(Step::classify);
  float last = 0;
  for (const char* name : {"isoValue", "alpha", "beta", "gamma", "isoShare", "lowPass"}) {
    const auto& rect = rects.byName.at(std::string("classification.") + name);
    EXPECT_GT(rect.min.y, last) << name;
    if (last > 0) {
      EXPECT_LT(rect.min.y, last + 40) << name;
    }
    last = rect.min.y;
  }
}

// Nothing that comes and goes moves a row: neither work, nor a result, nor what is said of it.
TEST_F(SidePanel, NoRowShiftsWhileAScanIsOpenedAndASurfaceMade) {
  std::map<std::string, WidgetRects::Rect> before;
  const Step steps[] = {Step::volume, Step::classify, Step::surface, Step::skin, Step::output};
  for (const Step step : steps) {
    open(step);
    before.insert(rects.byName.begin(), rects.byName.end());
  }
  const auto compare = [&](const char* when) {
    for (const auto& [name, rect] : rects.byName) {
      if (!before.contains(name) || name.starts_with("step.")) continue;
      EXPECT_EQ(rect.min.y, before.at(name).min.y) << name << when;
      EXPECT_EQ(rect.min.x, before.at(name).min.x) << name << when;
    }
  };
  workspace.session.openPhantom();
  frames(2);
  compare(" while it is opened");
  ASSERT_TRUE(test::wait(workspace.session));
  workspace.session.reconstruct();
  for (const Step step : steps) {
    open(step);
    compare(" while a surface is made");
  }
  ASSERT_TRUE(test::wait(workspace.session));
  ASSERT_TRUE(workspace.session.results().mesh);
  for (const Step step : steps) {
    open(step);
    compare(" when it is there");
  }
}

// What is hidden until it is asked for lies below what is seen before.
TEST_F(SidePanel, OpeningAHeadingMovesNothingAboveItNorOutOfThePanel) {
  makeSurface();
  for (const Step step : kSteps) {
    open(step);
    const auto closed = rects.byName;
    for (const auto& [name, heading] : closed) {
      if (!name.starts_with("foldout.")) continue;
      click(name);
      for (const auto& [other, rect] : closed) {
        if (rect.min.y >= heading.min.y && other != "surface.reconstruct") continue;
        EXPECT_EQ(rects.byName.at(other).min.y, rect.min.y) << other << " by " << name;
      }
      click(name);
    }
  }
}

TEST_F(SidePanel, WhatIsSimulatedIsNoneOfAFilesParameters) {
  open(Step::volume);
  EXPECT_TRUE(rects.byName.contains("phantom.dims"));
  const test::TempFolder folder;
  writeScan(folder / "scan.nrrd", makePhantomScan(test::tinySurface().phantom));
  workspace.session.openFile(folder / "scan.nrrd");
  ASSERT_TRUE(test::wait(workspace.session));
  frames(2);
  EXPECT_TRUE(rects.byName.contains("scan.spacing"));
  EXPECT_FALSE(rects.byName.contains("phantom.dims"));
  EXPECT_FALSE(rects.byName.contains("phantom.simulate"));
}

TEST_F(SidePanel, SimulatingAgainAsksBeforeASurfaceIsLost) {
  makeSurface();
  open(Step::volume);
  click("phantom.simulate");
  EXPECT_TRUE(workspace.question);
}

TEST_F(SidePanel, ToastsLieOverTheParametersAlone) {
  const auto& button = rects.byName.at("surface.reconstruct");
  EXPECT_LT(place.bottom, button.min.y);
  EXPECT_GE(place.left, 0);
  EXPECT_LE(place.left + place.width, 400);
}

TEST_F(SidePanel, TheKeysOfTheStepsOpenThem) {
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    EXPECT_TRUE(runShortcut({int('1' + i), true, false}, workspace));
    EXPECT_EQ(workspace.step, kSteps[i]);
  }
}

}  // namespace
}  // namespace sonoskin::ui
