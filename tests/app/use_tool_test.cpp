// The tools of the mouse without a window: which of them has it in which view, and what it leaves behind.
#include "app/views/use_tool.h"

#include "app/document/part_edits.h"
#include "app/views/steering.h"
#include "app/workspace/commands.h"
#include "tests/app/session_support.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

constexpr std::array kKinds{PaneKind::slice, PaneKind::space};

class UseTool : public ImGuiTest {
 protected:
  UseTool() : ImGuiTest({640, 420}), workspace(test::tinyPhantom()), view(workspace.view) {}

  void SetUp() override {
    ImGuiTest::SetUp();
    workspace.session.openPhantom();
    ASSERT_TRUE(test::wait(workspace.session));
    resetView(view, workspace.session.scan(), workspace.session.beam());
    input.size = {400, 400};
    input.mouse = {200, 200};
    input.hovered = true;
  }
  void reconstruct() {
    workspace.session.reconstruct();
    ASSERT_TRUE(test::wait(workspace.session));
    ASSERT_TRUE(hasParts(workspace.session.results()));
    workspace.session.followParameters(false);  // only the mouse is tested
    view.content = SpaceContent::mesh;
    workspace.lookAtFace();
  }
  ToolPane pane(PaneKind kind) const {
    if (kind == PaneKind::space) return {input};
    const Geometry& geometry = workspace.session.scan().volume->geometry;
    return {input, ToolPane::Slice{Plane::axial, frameOf(view, Plane::axial, geometry, input)}};
  }
  // One frame of a view.
  void frame(PaneKind kind) {
    beginFrame();
    useTool(state, workspace, pane(kind));
    drawTool(state, workspace, pane(kind));
    ImGui::End();
    ImGui::Render();
  }
  // The left button goes down, the mouse moves to a place, and goes up again there.
  void press(PaneKind kind) {
    input.button = ImGuiMouseButton_Left;
    input.pressed = true;
    input.moved = {0, 0};
    frame(kind);
    input.pressed = false;
  }
  void moveTo(PaneKind kind, const glm::vec2& mouse) {
    input.moved = mouse - input.mouse;
    input.mouse = mouse;
    frame(kind);
  }
  void release(PaneKind kind) {
    input.button = -1;
    input.moved = {0, 0};
    frame(kind);
  }

  Workspace workspace;
  ViewState& view;
  PaneInput input;
  ToolState state;
};

TEST_F(UseTool, WhatIsShownOrChosenHasTheButton) {
  EXPECT_EQ(toolIn(workspace, PaneKind::slice), Tool::cropBox);
  EXPECT_EQ(toolIn(workspace, PaneKind::space), Tool::cropBox);
  view.clip.on = true;
  EXPECT_EQ(toolIn(workspace, PaneKind::space), Tool::clipPlane);
  view.clip.on = false;
  view.cropBox = false;
  EXPECT_EQ(toolIn(workspace, PaneKind::slice), Tool::crossHair);
  view.sliceTool = Tool::eraser;
  EXPECT_EQ(toolIn(workspace, PaneKind::slice), Tool::eraser);
  EXPECT_EQ(toolIn(workspace, PaneKind::space), Tool::crossHair);
  EXPECT_TRUE(takesDoubleClicks(workspace, PaneKind::slice));
  EXPECT_FALSE(takesDoubleClicks(workspace, PaneKind::space));

  view.spaceTool = Tool::landmark;
  EXPECT_EQ(toolIn(workspace, PaneKind::space), Tool::crossHair) << "there is no skin yet";
  reconstruct();
  EXPECT_EQ(toolIn(workspace, PaneKind::space), Tool::landmark);
  EXPECT_EQ(toolIn(workspace, PaneKind::slice), Tool::eraser) << "each kind of view has its own";
  view.parts = true;
  EXPECT_EQ(toolIn(workspace, PaneKind::space), Tool::parts) << "skin is hidden";
  EXPECT_TRUE(takesDoubleClicks(workspace, PaneKind::space));
  view.parts = false;
  view.spaceTool = Tool::crossHair;
  EXPECT_EQ(toolIn(workspace, PaneKind::space), Tool::lamp);
  view.meshStyle = MeshStyle::clay;
  EXPECT_EQ(toolIn(workspace, PaneKind::space), Tool::crossHair);
}

// Whatever is chosen, and whatever was held: a view of either kind can be used, and no tool keeps a button that is up.
TEST_F(UseTool, EveryToolInBothKindsOfViews) {
  reconstruct();
  for (const Tool tool : kTools)
    for (const PaneKind kind : kKinds)
      for (const bool parts : {false, true}) {
        view.parts = parts;
        view.sliceTool = view.spaceTool = tool;
        state = {};
        press(kind);
        moveTo(kind, input.mouse + glm::vec2(3, 2));
        EXPECT_EQ(view.toolHeld, state.held.has_value()) << int(tool);
        release(kind);
        EXPECT_FALSE(state.held || view.toolHeld) << int(tool);
        state.held = tool;
        view.toolHeld = true;
        frame(kind);
        EXPECT_FALSE(state.held || view.toolHeld) << int(tool);
        ASSERT_TRUE(test::wait(workspace.session));
      }
}

TEST_F(UseTool, TheEraserLeavesTheCrossHairAlone) {
  const glm::dvec3 cursor = view.cursor;
  const Camera camera = view.camera;
  view.sliceTool = Tool::eraser;
  press(PaneKind::slice);
  EXPECT_TRUE(view.toolHeld);
  const std::size_t dab = workspace.session.erased().voxels();
  EXPECT_GT(dab, 0u);
  moveTo(PaneKind::slice, {230, 200});
  EXPECT_GT(workspace.session.erased().voxels(), dab);
  EXPECT_FALSE(workspace.session.canUndo()) << "not before it is let go";
  release(PaneKind::slice);
  EXPECT_TRUE(workspace.session.canUndo());
  EXPECT_EQ(view.cursor, cursor);

  // In 3D the button is the camera's.
  press(PaneKind::space);
  moveTo(PaneKind::space, {260, 200});
  release(PaneKind::space);
  EXPECT_NE(view.camera.forward, camera.forward);
  EXPECT_TRUE(view.cameraMoved);
}

// The outline goes through places that the mouse passed between two frames.
TEST_F(UseTool, TheLassoCutsThroughSlicesAndThroughTheViewIn3D) {
  const glm::dvec3 cursor = view.cursor;
  const Camera camera = view.camera;
  const ErasedParts& erased = workspace.session.erased();
  for (const PaneKind kind : kKinds) {
    view.sliceTool = view.spaceTool = Tool::lasso;
    input.corner = {30, 20};
    input.mouse = {160, 160};
    press(kind);
    view.trail = {input.corner + glm::vec2(240, 160)};
    moveTo(kind, {240, 240});
    view.trail.clear();
    moveTo(kind, {160, 240});
    EXPECT_EQ(erased.voxels(), 0u) << "not before it is let go";
    EXPECT_TRUE(view.toolHeld);
    release(kind);
    const std::size_t through = erased.voxels();
    EXPECT_GT(through, 1000u);
    EXPECT_TRUE(workspace.session.canUndo());
    workspace.session.undo();
    EXPECT_EQ(erased.voxels(), 0u);

    view.lassoDepth = 3;
    press(kind);
    for (const glm::vec2& at : {glm::vec2(240, 160), glm::vec2(240, 240), glm::vec2(160, 240)})
      moveTo(kind, at);
    release(kind);
    EXPECT_LT(erased.voxels(), through);
    view.lassoDepth = 0;
    workspace.session.clearErased();
  }
  EXPECT_EQ(view.cursor, cursor);
  EXPECT_EQ(view.camera.forward, camera.forward);
}

TEST_F(UseTool, EscapeGivesAnOutlineUp) {
  view.spaceTool = Tool::lasso;
  press(PaneKind::space);
  for (const glm::vec2& at : {glm::vec2(240, 160), glm::vec2(240, 240)}) moveTo(PaneKind::space, at);
  command("surface.cancel").run(workspace);
  release(PaneKind::space);
  EXPECT_EQ(workspace.session.erased().voxels(), 0u);
  EXPECT_TRUE(state.outline.empty());
}

TEST_F(UseTool, EscapeEndsAStroke) {
  view.sliceTool = Tool::eraser;
  press(PaneKind::slice);
  command("surface.cancel").run(workspace);
  ASSERT_EQ(view.sliceTool, Tool::crossHair);
  const std::size_t voxels = workspace.session.erased().voxels();
  moveTo(PaneKind::slice, {230, 200});
  EXPECT_FALSE(state.held);
  EXPECT_EQ(workspace.session.erased().voxels(), voxels);
  release(PaneKind::slice);
  EXPECT_TRUE(workspace.session.canUndo()) << "what was erased is a step";
}

// Two clicks measure a distance, a drag does as well; marks can be moved; the cross-hair stays.
TEST_F(UseTool, MarksAreSetByClicksAndDrags) {
  view.sliceTool = Tool::measure;
  const glm::dvec3 cursor = view.cursor;
  const double mm = pane(PaneKind::slice).slice->frame.millimetresPerPixel();
  const auto click = [&](const glm::vec2& at) {
    input.mouse = at;
    press(PaneKind::slice);
    release(PaneKind::slice);
  };
  click({150, 200});
  EXPECT_TRUE(view.measureBegun);
  EXPECT_TRUE(view.measures.empty());
  click({230, 260});
  ASSERT_EQ(view.measures.size(), 1u);
  EXPECT_NEAR(valueOf(view.measures[0]), 100 * mm, 1e-6);

  input.mouse = {100, 100};
  press(PaneKind::slice);
  moveTo(PaneKind::slice, {160, 180});
  release(PaneKind::slice);
  ASSERT_EQ(view.measures.size(), 2u) << "a drag";
  EXPECT_NEAR(valueOf(view.measures[1]), 100 * mm, 1e-6);

  input.mouse = {231, 259};
  press(PaneKind::slice);
  moveTo(PaneKind::slice, {350, 200});
  release(PaneKind::slice);
  EXPECT_NEAR(valueOf(view.measures[0]), 200 * mm, 1e-6) << "the mark was moved";
  EXPECT_EQ(view.measures.size(), 2u);

  view.measuring = MeasureKind::area;
  for (const glm::vec2 at : {glm::vec2(50, 300), {150, 300}, {150, 350}, {50, 350}, {51, 301}}) click(at);
  ASSERT_EQ(view.measures.size(), 3u) << "closed at its first mark";
  EXPECT_NEAR(valueOf(view.measures[2]), 5000 * mm * mm, 1e-6);
  EXPECT_EQ(view.cursor, cursor);

  click({300, 300});
  ASSERT_TRUE(view.measureBegun);
  command("surface.cancel").run(workspace);
  EXPECT_FALSE(view.measureBegun) << "Escape gives up what was begun";
  EXPECT_EQ(view.sliceTool, Tool::crossHair);
}

// A line that was begun and given up splits nothing, at once or when parts are shown again.
TEST_F(UseTool, EscapeGivesUpALineAcrossParts) {
  reconstruct();
  view.parts = true;
  input.mouse = {120, 200};
  input.control = true;
  press(PaneKind::space);
  moveTo(PaneKind::space, {280, 200});
  EXPECT_EQ(state.held, Tool::parts);
  command("surface.cancel").run(workspace);
  ASSERT_FALSE(view.parts);
  release(PaneKind::space);
  view.parts = true;
  frame(PaneKind::space);
  EXPECT_TRUE(workspace.session.parameters().mesh.partsCut.empty());

  press(PaneKind::space);
  moveTo(PaneKind::space, {120, 200});
  release(PaneKind::space);
  EXPECT_FALSE(workspace.session.parameters().mesh.partsCut.empty()) << "the same line, drawn to its end";
}

}  // namespace
}  // namespace sonoskin::ui
