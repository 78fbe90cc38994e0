// What can be dragged in 3D: the sides of the crop box and the plane that cuts.
#include "app/views/space_handles.h"

#include "app/views/box_lines.h"
#include "app/views/projection.h"
#include "app/views/use_tool.h"
#include "app/workspace/clip_edits.h"
#include "tests/app/session_support.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

class SpaceHandles : public ImGuiTest {
 protected:
  SpaceHandles() : ImGuiTest({640, 420}), workspace(test::tinyPhantom()), view(workspace.view) {}

  void SetUp() override {
    ImGuiTest::SetUp();
    workspace.session.openPhantom();
    ASSERT_TRUE(test::wait(workspace.session));
    resetView(view, workspace.session.scan(), workspace.session.beam());
    view.camera.orbit(0.7f, 0.4f);  // no side is seen from its edge
    pane.size = {400, 400};
    pane.hovered = true;
    frame();
  }
  void frame() {
    beginFrame();
    useTool(state, workspace, {pane});
    drawCropHandles(state, workspace, pane);
    if (view.clip.on) drawClipHandle(state, workspace, pane);
    ImGui::End();
    ImGui::Render();
    pane.pressed = false;
  }
  glm::vec2 middleOf(const std::string& handle) const {
    const auto& [min, max] = rects.byName.at(handle);
    return {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)};
  }
  // Presses the left button on a handle and moves it by some pixels; the button stays down.
  void drag(const std::string& handle, glm::vec2 by) {
    pane.mouse = middleOf(handle);
    pane.button = ImGuiMouseButton_Left;
    pane.pressed = true;
    pane.moved = {0, 0};
    frame();
    pane.mouse += by;
    pane.moved = by;
    frame();
  }
  void letGo() {
    pane.button = -1;
    pane.moved = {0, 0};
    frame();
  }

  Workspace workspace;
  ViewState& view;
  PaneInput pane;
  ToolState state;
};

// Every side follows the mouse along its own axis, stays under it, and moves no other side nor the camera.
TEST_F(SpaceHandles, SidesOfTheBoxFollowTheMouse) {
  for (const char* name : {"crop.i-", "crop.i+", "crop.j-", "crop.j+", "crop.k-", "crop.k+"}) {
    SCOPED_TRACE(name);
    const RegionOptions before = workspace.session.parameters().region;
    const glm::vec3 eye = view.camera.eye();
    const glm::vec2 inward = 0.12f * (glm::vec2(200, 200) - middleOf(name));
    drag(name, inward);
    EXPECT_EQ(state.held, Tool::cropBox);
    letGo();
    EXPECT_EQ(view.camera.eye(), eye);
    const RegionOptions& after = workspace.session.parameters().region;
    int moved = 0;
    for (std::size_t a = 0; a < 3; ++a)
      moved += (after.cutLow[a] != before.cutLow[a]) + (after.cutHigh[a] != before.cutHigh[a]);
    EXPECT_EQ(moved, 1);
    EXPECT_LT(glm::distance(middleOf(name), pane.mouse), 6);
    ASSERT_TRUE(test::wait(workspace.session));
  }
  EXPECT_TRUE(workspace.session.canUndo());
  workspace.session.undo();
  EXPECT_EQ(workspace.session.parameters().region.cutHigh[2], 0);
}

TEST_F(SpaceHandles, DoNotLieOverAFinishedFace) {
  EXPECT_TRUE(showsBoxInSpace(workspace)) << "of a volume that is still to be cropped";
  workspace.session.reconstruct();
  ASSERT_TRUE(test::wait(workspace.session));
  view.content = SpaceContent::mesh;
  EXPECT_FALSE(showsBoxInSpace(workspace));
  drag("crop.i+", {-20, 0});
  EXPECT_FALSE(state.held) << "what is not seen cannot be dragged";
  letGo();
  workspace.step = Step::region;
  EXPECT_TRUE(showsBoxInSpace(workspace));
  drag("crop.i+", {-20, 0});
  EXPECT_TRUE(state.held);
}

TEST_F(SpaceHandles, BesideThemTheCameraTurns) {
  const glm::vec3 eye = view.camera.eye();
  pane.mouse = {5, 5};
  pane.button = ImGuiMouseButton_Left;
  pane.pressed = true;
  frame();
  pane.moved = {30, 0};
  frame();
  EXPECT_FALSE(state.held);
  EXPECT_NE(view.camera.eye(), eye);
}

TEST_F(SpaceHandles, ThePlaneFollowsItsHandle) {
  clipFromPlane(workspace, Plane::axial);
  frame();
  const float before = clipDepth(workspace);
  drag("clip.handle", {0, -25});
  EXPECT_EQ(state.held, Tool::clipPlane);
  letGo();
  EXPECT_GT(std::abs(clipDepth(workspace) - before), 1);
  EXPECT_LT(glm::distance(middleOf("clip.handle"), pane.mouse), 25) << "it follows along its normal";
  // Toward the eye, upward pushes it away.
  view.clip = {};
  clipFromView(workspace);
  frame();
  const float middle = clipDepth(workspace);
  drag("clip.handle", {0, -25});
  letGo();
  EXPECT_GT(clipDepth(workspace), middle + 1);
}

TEST_F(SpaceHandles, FlippedItKeepsTheOtherSide) {
  switchClip(workspace);
  ASSERT_TRUE(view.clip.on);
  const glm::vec3 near = view.camera.eye(),
                  far = view.camera.target + view.camera.distance * view.camera.forward;
  EXPECT_FALSE(view.clip.plane.keeps(near));
  EXPECT_TRUE(view.clip.plane.keeps(far));
  flipClip(workspace);
  EXPECT_TRUE(view.clip.plane.keeps(near));
  EXPECT_FALSE(view.clip.plane.keeps(far));
  const auto [least, most] = clipRange(workspace);
  moveClip(workspace, 1e6f);
  EXPECT_FLOAT_EQ(clipDepth(workspace), most);
  EXPECT_LT(least, 0);
  switchClip(workspace);
  EXPECT_FALSE(view.clip.on);
}

}  // namespace
}  // namespace sonoskin::ui
