#include "app/workspace/commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "app/workspace/workspace.h"
#include "tests/app/session_support.h"

namespace sonoskin {
namespace {

TEST(Commands, NoIdAndNoKeyTwice) {
  std::set<std::string> ids;
  std::set<std::string> keys;
  for (const Command& command : commands()) {
    EXPECT_TRUE(ids.insert(command.id).second) << command.id;
    if (command.shortcut.key != 0) {
      EXPECT_TRUE(keys.insert(shortcutText(command.shortcut)).second) << command.id;
    }
    EXPECT_TRUE(command.run != nullptr);
  }
}

// The keys that the design promises.
TEST(Commands, PromisedKeys) {
  const std::pair<const char*, const char*> promised[] = {
      {"file.open", "Ctrl+O"},   {"file.saveMesh", "Ctrl+S"},
      {"edit.undo", "Ctrl+Z"},   {"edit.redo", "Ctrl+Shift+Z"},
      {"view.resetCamera", "R"}, {"file.savePicture", "F12"},
      {"help.keys", "H"},        {"help.palette", "Ctrl+K"},
      {"surface.parts", "P"},    {"surface.cancel", "Esc"}};
  for (const auto& [id, keys] : promised) EXPECT_EQ(shortcutText(command(id).shortcut), keys) << id;
}

TEST(Commands, NothingThatNeedsAScanWithoutOne) {
  const Workspace workspace{Parameters()};
  for (const char* id : {"file.saveMesh", "file.savePrint", "file.savePicture", "view.resetCamera",
                         "surface.reconstruct", "edit.undo", "surface.parts", "surface.faceAlone"}) {
    EXPECT_FALSE(isEnabled(command(id), workspace)) << id;
  }
  EXPECT_TRUE(isEnabled(command("file.open"), workspace));
}

bool canEscape(const Workspace& workspace) { return isEnabled(command("surface.cancel"), workspace); }
void escape(Workspace& workspace) { command("surface.cancel").run(workspace); }

TEST(Escape, PutsEveryToolAway) {
  for (const Tool tool : kTools) {
    Workspace workspace{Parameters()};
    ViewState& view = workspace.view;
    view.sliceTool = view.spaceTool = tool;
    EXPECT_EQ(canEscape(workspace), tool != Tool::crossHair) << int(tool);
    escape(workspace);
    EXPECT_EQ(view.sliceTool, Tool::crossHair) << int(tool);
    EXPECT_EQ(view.spaceTool, Tool::crossHair) << int(tool);
    EXPECT_FALSE(canEscape(workspace)) << int(tool);
  }
}

// One thing at a time, and work that a person waits for before the tools that wait for it.
TEST(Escape, EndsWhatIsMostInTheWay) {
  Workspace workspace{Parameters()};
  ViewState& view = workspace.view;
  view.maximised = Pane::space;
  view.parts = true;
  view.sliceTool = Tool::eraser;
  view.spaceTool = Tool::landmark;
  workspace.session.openPhantom();
  workspace.question = {"Quitting", [] {}};
  escape(workspace);
  EXPECT_FALSE(workspace.question);
  EXPECT_EQ(view.spaceTool, Tool::landmark);
  escape(workspace);
  EXPECT_EQ(view.spaceTool, Tool::crossHair);
  ASSERT_TRUE(workspace.session.activity().blocking);
  escape(workspace);
  ASSERT_TRUE(test::wait(workspace.session));
  EXPECT_FALSE(workspace.session.hasScan());
  EXPECT_EQ(view.sliceTool, Tool::eraser);
  escape(workspace);
  EXPECT_EQ(view.sliceTool, Tool::crossHair);
  EXPECT_TRUE(view.parts);
  escape(workspace);
  EXPECT_FALSE(view.parts);
  EXPECT_TRUE(view.maximised);
  escape(workspace);
  EXPECT_FALSE(view.maximised);
  EXPECT_FALSE(canEscape(workspace));
}

TEST(Commands, ScaleGoesByQuartersFromWhereTheScreenHasIt) {
  Workspace workspace{Parameters()};
  workspace.screenScale = 1.6;
  double& scale = workspace.settings.scale;
  command("view.larger").run(workspace);
  EXPECT_EQ(scale, 1.75);
  command("view.smaller").run(workspace);
  command("view.smaller").run(workspace);
  EXPECT_EQ(scale, 1.25);
  command("view.smaller").run(workspace);
  EXPECT_EQ(scale, kLeastScale);
  EXPECT_FALSE(isEnabled(command("view.smaller"), workspace));
  scale = kMostScale;
  EXPECT_FALSE(isEnabled(command("view.larger"), workspace));
  command("view.autoScale").run(workspace);
  EXPECT_EQ(scale, 0);
  command("view.light").run(workspace);
  EXPECT_EQ(workspace.settings.appearance, Appearance::light);
  EXPECT_TRUE(command("view.light").checked(workspace));
}

// Whatever goes on behind them, windows that help are closed first, one at a time.
TEST(Escape, ClosesHelpAndEndsNothing) {
  Parameters small;
  small.phantom.dims = {117, 64, 31};
  Workspace workspace{small};
  workspace.session.openPhantom();
  workspace.view.spaceTool = Tool::landmark;
  workspace.keysShown = workspace.aboutShown = true;
  workspace.help.tour = 1;
  workspace.toasts.log.open();
  escape(workspace);
  EXPECT_FALSE(workspace.keysShown);
  EXPECT_TRUE(workspace.aboutShown);
  escape(workspace);
  EXPECT_FALSE(workspace.aboutShown);
  EXPECT_TRUE(workspace.help.tour);
  escape(workspace);
  EXPECT_FALSE(workspace.help.tour);
  EXPECT_TRUE(workspace.toasts.log.shown);
  escape(workspace);
  EXPECT_FALSE(workspace.toasts.log.shown);
  EXPECT_EQ(workspace.view.spaceTool, Tool::landmark);
  EXPECT_TRUE(workspace.session.activity().blocking);
  ASSERT_TRUE(test::wait(workspace.session));
  EXPECT_TRUE(workspace.session.hasScan()) << "the opening was ended";
}

TEST(Commands, UndoRunsOnTheWorkspace) {
  Workspace workspace{Parameters()};
  Parameters changed;
  changed.classification.alpha = 2;
  workspace.session.edit(changed);
  workspace.session.commitEdit();
  command("edit.undo").run(workspace);
  EXPECT_DOUBLE_EQ(workspace.session.parameters().classification.alpha, 1);
  command("edit.redo").run(workspace);
  EXPECT_DOUBLE_EQ(workspace.session.parameters().classification.alpha, 2);
}

}  // namespace
}  // namespace sonoskin
