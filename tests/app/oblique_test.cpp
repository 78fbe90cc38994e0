// The slice that can be turned, without a window.
#include <gtest/gtest.h>

#include <cmath>

#include "app/views/four_up.h"
#include "app/views/oblique_marks.h"
#include "app/views/steering.h"
#include "app/views/use_tool.h"
#include "app/workspace/commands.h"
#include "app/workspace/view_file.h"
#include "render/gl/context.h"
#include "tests/app/session_support.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

class Oblique : public ImGuiTest {
 protected:
  Oblique() : ImGuiTest({800, 600}), workspace(test::tinyPhantom()), view(workspace.view) {}

  void SetUp() override {
    ImGuiTest::SetUp();
    context_->makeCurrent();
    workspace.session.openPhantom();
    ASSERT_TRUE(test::wait(workspace.session));
    resetView(view, workspace.session.scan(), workspace.session.beam());
    command("layout.oblique").run(workspace);
    input.size = {400, 300};
    input.hovered = true;
  }
  const Geometry& geometry() const { return workspace.session.scan().volume->geometry; }
  PlaneDirections axial() const { return directionsOf(geometry(), view.planes[Plane::axial]); }
  ObliqueAngles angles() const { return anglesOf(view.oblique.directions, axial()); }
  ToolPane pane(SlicePlane plane) const {
    return {input, ToolPane::Slice{plane, frameOf(view, plane, geometry(), input)}};
  }
  void frame(SlicePlane plane, const glm::vec2& mouse, bool down) {
    input.pressed = down && input.button < 0;
    input.button = down ? ImGuiMouseButton_Left : -1;
    input.moved = mouse - input.mouse;
    input.mouse = mouse;
    beginFrame();
    useTool(state, workspace, pane(plane));
    ImGui::End();
    ImGui::Render();
  }

 private:
  std::unique_ptr<gl::Context> context_ = gl::makeOffscreenContext(gl::Backend::egl);

 protected:
  Workspace workspace;
  ViewState& view;
  PaneInput input;
  ToolState state;
};

// The end of the line is dragged around the cross-hair by 40 degrees: the plane turns by as many about the slice's normal.
TEST_F(Oblique, FollowsTheEndOfItsLineAroundTheCrossHair) {
  const Plane plane = Plane::sagittal;
  EXPECT_NEAR(angles().tilt, 30, 1e-9) << "what it is shows at once";
  const glm::dvec3 normal = view.oblique.directions.normal(), cursor = view.cursor;
  const auto ends = obliqueEnds(workspace, pane(plane));
  ASSERT_TRUE(ends);
  const glm::dvec2 middle = pane(plane).slice->frame.toPixel(cursor);
  const glm::dvec2 arm = glm::dvec2((*ends)[0]) - middle;
  const auto place = [&](double degrees) {
    const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
    return glm::vec2(middle + glm::dvec2(c * arm.x - s * arm.y, s * arm.x + c * arm.y));
  };
  frame(plane, place(0), false);
  frame(plane, place(0), true);
  for (const double degrees : {10.0, 25.0, 40.0}) frame(plane, place(degrees), true);
  frame(plane, place(40), false);
  EXPECT_NEAR(glm::degrees(std::acos(glm::dot(view.oblique.directions.normal(), normal))), 40, 1e-3);
  EXPECT_EQ(view.cursor, cursor) << "the cross-hair stays";
  const auto moved = obliqueEnds(workspace, pane(plane));
  ASSERT_TRUE(moved);
  const glm::dvec2 after = glm::normalize(glm::dvec2((*moved)[0]) - middle);
  EXPECT_NEAR(std::abs(glm::dot(after, glm::normalize(glm::dvec2(place(40)) - middle))), 1, 1e-4)
      << "the line is where the mouse is";
}

TEST_F(Oblique, LeavesTheMiddleOfItsLineToTheCrossHair) {
  const PlaneDirections before = view.oblique.directions;
  const auto ends = obliqueEnds(workspace, pane(Plane::sagittal));
  const glm::vec2 middle(pane(Plane::sagittal).slice->frame.toPixel(view.cursor));
  const glm::vec2 halfway = glm::mix(middle, (*ends)[0], 0.5f);
  frame(Plane::sagittal, halfway, false);
  frame(Plane::sagittal, halfway, true);
  EXPECT_NE(state.held, Tool::oblique);
  EXPECT_EQ(view.oblique.directions, before);
}

TEST_F(Oblique, ItsOwnPictureStaysWhileTheCrossHairMovesInIt) {
  const SliceFrame before = pane(std::nullopt).slice->frame;
  frame(std::nullopt, {180, 140}, false);
  frame(std::nullopt, {180, 140}, true);
  frame(std::nullopt, {215, 165}, true);
  EXPECT_LT(glm::distance(glm::vec2(before.toPixel(view.cursor)), glm::vec2(215, 165)), 1e-3);
  EXPECT_LT(glm::distance(pane(std::nullopt).slice->frame.corner, before.corner), 1e-9);
}

TEST_F(Oblique, TurnsByKeysAndIsSetBack) {
  ASSERT_TRUE(runShortcut(command("oblique.left").shortcut, workspace));
  EXPECT_NEAR(angles().turn, 5, 1e-9);
  ASSERT_TRUE(runShortcut(command("oblique.up").shortcut, workspace));
  const double tilted = glm::degrees(std::acos(glm::dot(view.oblique.directions.normal(), axial().normal())));
  EXPECT_GT(tilted, 33);
  command("oblique.reset").run(workspace);
  EXPECT_EQ(view.oblique.directions, axial());
  command("layout.fourUp").run(workspace);
  EXPECT_FALSE(isEnabled(command("oblique.left"), workspace));
}

TEST_F(Oblique, TheWheelGoesAlongItsNormal) {
  const glm::dvec3 before = view.cursor;
  input.wheel = 1;
  frame(std::nullopt, {200, 150}, false);
  const glm::dvec3 moved = view.cursor - before;
  EXPECT_NEAR(glm::length(moved), geometry().minSpacing(), 1e-9);
  EXPECT_NEAR(std::abs(glm::dot(glm::normalize(moved), view.oblique.directions.normal())), 1, 1e-9);
}

TEST_F(Oblique, IsKeptInSessions) {
  view.oblique.directions = directionsAt({40, 20, -15}, axial());
  view.oblique.pose.zoom = 2;
  view.maximised = Pane::oblique;
  ViewState read;
  readViews(writeViews(view), read);
  EXPECT_LT(glm::distance(read.oblique.directions.right, view.oblique.directions.right), 1e-9);
  EXPECT_LT(glm::distance(read.oblique.directions.down, view.oblique.directions.down), 1e-9);
  EXPECT_EQ(read.oblique.pose.zoom, 2);
  EXPECT_EQ(read.maximised, Pane::oblique);
  readViews(R"({"oblique": {"right": [1, 0, 0], "down": [0.9, 0.1, 0]}})", read);
  EXPECT_LT(glm::distance(read.oblique.directions.right, view.oblique.directions.right), 1e-9) << "no plane";
}

// All views of the layout are drawn, also where a session shows one alone that the layout lacks.
TEST_F(Oblique, IsDrawnBesideTheOthers) {
  FourUp views;
  const auto draw = [&] {
    beginFrame();
    drawFourUp(views, workspace);
    ImGui::End();
    ImGui::Render();
  };
  for (int n = 0; n < 20; ++n) draw();
  EXPECT_EQ(views.shown.size(), 5u);
  EXPECT_TRUE(views.oblique.picture);
  const Key drawn = views.oblique.drawn;
  command("oblique.up").run(workspace);
  draw();
  EXPECT_NE(views.oblique.drawn, drawn);
  command("layout.fourUp").run(workspace);
  view.maximised = Pane::oblique;
  draw();
  EXPECT_EQ(views.shown.size(), 4u);
}

}  // namespace
}  // namespace sonoskin::ui
