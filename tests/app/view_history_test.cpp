// Marks, clip plane and colours in the history of the document.
#include "app/workspace/view_history.h"

#include <gtest/gtest.h>

#include "app/workspace/clip_edits.h"
#include "app/workspace/commands.h"
#include "app/workspace/session_actions.h"
#include "app/workspace/step_title.h"
#include "app/workspace/workspace.h"
#include "tests/app/session_support.h"

namespace sonoskin {
namespace {

class ViewHistory : public testing::Test {
 protected:
  ViewHistory() : w(test::tinyPhantom()) {
    w.session.openPhantom();
    EXPECT_TRUE(test::wait(w.session));
    resetView(w.view, w.session.scan(), w.session.beam());
    takeInOpened(w);
  }
  void frame(bool held = false) { noteViewEdits(w, held); }
  void run(const char* id) {
    command(id).run(w);
    frame();
  }
  void measure(double mm) {
    w.view.measures.push_back({MeasureKind::distance, {{0, 0, 0}, {mm, 0, 0}}});
    frame();
  }
  std::size_t steps() const { return w.session.history().position(); }
  std::string title() const {
    const auto& history = w.session.history();
    return stepTitle(history.at(history.position() - 1), history.at(history.position()));
  }

  Workspace w;
};

TEST_F(ViewHistory, MarksThatAreSetMovedAndDeletedAreTakenBack) {
  measure(12);
  EXPECT_EQ(title(), "Distance 12.0 mm");
  for (const double mm : {13.0, 15.0, 20.0}) {
    w.view.measures[0].marks[1].x = mm;
    frame(true);
  }
  frame();
  EXPECT_EQ(steps(), 2u) << "one drag is one step";
  EXPECT_EQ(title(), "Distance 12.0 mm → 20.0 mm");
  run("measure.deleteLast");
  EXPECT_EQ(title(), "Distance 20.0 mm deleted");
  EXPECT_TRUE(w.view.measures.empty());
  run("edit.undo");
  ASSERT_EQ(w.view.measures.size(), 1u);
  EXPECT_EQ(w.view.measures[0].marks[1].x, 20);
  run("edit.undo");
  EXPECT_EQ(w.view.measures[0].marks[1].x, 12);
  run("edit.undo");
  EXPECT_TRUE(w.view.measures.empty());
  EXPECT_FALSE(w.session.canUndo());
  run("edit.redo");
  run("edit.redo");
  EXPECT_EQ(w.view.measures[0].marks[1].x, 20);
}

TEST_F(ViewHistory, TheClipPlaneIsTakenBack) {
  run("clip.on");
  EXPECT_EQ(title(), "Clip plane");
  const ClipShow first = w.view.clip;
  for (const float depth : {1.f, 3.f, 5.f}) {
    moveClip(w, depth);
    frame(true);
  }
  frame();
  EXPECT_EQ(title(), "Clip plane moved");
  run("clip.flip");
  EXPECT_EQ(title(), "Clip plane: the other side");
  run("clip.axial");
  EXPECT_EQ(title(), "Clip plane turned");
  for (int n = 0; n < 3; ++n) run("edit.undo");
  EXPECT_EQ(w.view.clip, first);
  run("edit.undo");
  EXPECT_FALSE(w.view.clip.on);
}

TEST_F(ViewHistory, ColoursAreTakenBack) {
  w.view.volume.colours = "bone";
  frame();
  EXPECT_EQ(title(), "Colours: Bone");
  w.view.volume.own = LevelledTransfer{boneTransfer(0.3f), 0.3f};
  w.view.volume.changed = true;
  frame(true);
  w.view.volume.own->function.points.back().opacity = 0.25f;
  w.view.volume.selected = 4;
  frame();
  EXPECT_EQ(title(), "Colours edited");
  run("edit.undo");
  EXPECT_FALSE(w.view.volume.own);
  EXPECT_EQ(w.view.volume.selected, -1);
  run("edit.undo");
  EXPECT_EQ(w.view.volume.colours, "amber");
  run("edit.redo");
  run("edit.redo");
  EXPECT_EQ(w.view.volume.own->function.points.back().opacity, 0.25f);
}

// Parameters, what was erased and marks are steps of one list.
TEST_F(ViewHistory, IsTheOneOfTheParameters) {
  measure(5);
  Parameters parameters = w.session.parameters();
  parameters.classification.alpha = 0.4;
  w.session.edit(parameters);
  w.session.commitEdit();
  measure(7);
  EXPECT_EQ(w.session.history().size(), 4u);
  run("edit.undo");
  EXPECT_EQ(w.session.parameters().classification.alpha, 0.4);
  EXPECT_EQ(w.view.measures.size(), 1u);
  run("edit.undo");
  EXPECT_NE(w.session.parameters().classification.alpha, 0.4);
  EXPECT_EQ(w.view.measures.size(), 1u);
  w.session.goToStep(3);
  frame();
  EXPECT_EQ(w.view.measures.size(), 2u);
}

TEST_F(ViewHistory, AnotherDocumentBeginsWithoutSteps) {
  measure(5);
  w.session.openPhantom();
  ASSERT_TRUE(test::wait(w.session));
  w.view.measures.clear();
  takeInOpened(w);
  frame();
  EXPECT_FALSE(w.session.canUndo()) << "marks of another scan do not come back";
}

}  // namespace
}  // namespace sonoskin
