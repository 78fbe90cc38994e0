// Questions and dialogs by keys alone, and what Escape ends.
#include "app/workspace/commands.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/app/injected_player.h"
#include "tests/app/session_script.h"
#include "tests/support/temp_folder.h"

namespace sonoskin::test {
namespace {

namespace fs = std::filesystem;

class QuestionKeys : public testing::Test {
 protected:
  QuestionKeys() {
    setenv("XDG_CONFIG_HOME", (folder.path() / "settings").c_str(), 1);
    setenv("XDG_STATE_HOME", (folder.path() / "state").c_str(), 1);
    player_.emplace(scriptParameters());
    p().workspace().settings.folder = folder.path();
  }
  void SetUp() override { ASSERT_TRUE(p().untilIdle()); }
  Player& p() { return *player_; }
  void keys(std::initializer_list<const char*> names) {
    for (const char* name : names) p().key(name);
  }

  const TempFolder folder;

 private:
  std::optional<InjectedPlayer> player_;
};

TEST_F(QuestionKeys, TabGoesToAllThatAQuestionHas) {
  p().key("F12");
  ASSERT_TRUE(p().workspace().pictureRequest);
  const bool transparent = p().workspace().pictureFormat.transparent;
  // Width, height, three usual sizes, the background, Cancel, Save.
  keys({"Tab", "Tab", "Tab", "Tab", "Tab", "space"});
  EXPECT_NE(p().workspace().pictureFormat.transparent, transparent) << "the box of the background";
  keys({"shift+Tab", "space"});
  EXPECT_EQ(p().workspace().pictureFormat.size, (std::array{3840, 2160})) << "the last of the usual sizes";
  keys({"Tab", "Tab", "Tab", "Return"});
  EXPECT_FALSE(p().workspace().pictureRequest);
  EXPECT_EQ(p().workspace().files.purpose, ui::FilePurpose::savePicture);
  p().key("Escape");
}

TEST_F(QuestionKeys, ANumberThatTabLeavesIsTaken) {
  p().key("F12");
  keys({"Tab", "shift+Tab", "Return"});
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  p().hand({keyPress("ctrl+a"), typing("640")});
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  keys({"Tab"});
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(p().workspace().pictureFormat.size[0], 640);
  p().key("Escape");
}

// From the name up to the folder, and in it to the file.
TEST_F(QuestionKeys, TheFileDialogIsPassedByKeys) {
  fs::create_directory(folder / "scans");
  writeScan(folder / "scans" / "scan.nrrd", makePhantomScan(scriptParameters().phantom));
  p().key("ctrl+o");
  ASSERT_TRUE(p().workspace().files.purpose);
  const auto opened = p().session().opened();
  keys({"shift+Tab", "Up", "Right", "Up", "Return"});
  EXPECT_EQ(p().workspace().files.folder, folder / "scans");
  keys({"Down", "Up", "Right", "Return"});
  ASSERT_FALSE(p().workspace().files.purpose);
  ASSERT_TRUE(p().wait([&] { return p().session().opened() != opened; }));
  EXPECT_EQ(p().session().name(), "scan.nrrd");
  ASSERT_TRUE(p().untilIdle());
}

TEST_F(QuestionKeys, EscapeClosesWhatLiesOnTopAndEndsNoWork) {
  p().session().reconstruct();
  for (const char* opens : {"help.about", "help.keys", "edit.history", "file.savePicture"}) {
    command(opens).run(p().workspace());
    p().frames(3);
    p().key("Escape");
    EXPECT_NE(p().session().state(), DocumentState::stopped) << opens;
    EXPECT_FALSE(p().workspace().aboutShown || p().workspace().keysShown || p().workspace().historyShown ||
                 p().workspace().pictureRequest)
        << opens;
  }
  ASSERT_TRUE(p().session().activity().busy) << "it was over before Escape came";
  p().key("Escape");
  ASSERT_TRUE(p().wait([&] { return !p().session().activity().busy; }));
  EXPECT_EQ(p().session().state(), DocumentState::stopped) << "then it ends the work";
}

TEST_F(QuestionKeys, OfTwoQuestionsTheSecondWaitsForTheFirst) {
  Workspace& w = p().workspace();
  bool later = false;
  w.lostVolume = LostVolume{};
  w.recovery = Workspace::Recovery{"today", [] {}, [&] { later = true; }};
  p().frames(6);
  ASSERT_TRUE(p().rects().byName.contains("lost.cancel"));
  EXPECT_FALSE(p().rects().byName.contains("recovery.discard"));
  p().click("lost.cancel");
  p().frames(6);
  EXPECT_FALSE(w.lostVolume);
  ASSERT_TRUE(p().rects().byName.contains("recovery.discard"));
  p().click("recovery.discard");
  EXPECT_TRUE(later);
}

TEST(Interface, ADenseScreenWithoutAScaleHasTwo) {
  EXPECT_EQ(scaleOfScreen(1, 3840), 2);
  EXPECT_EQ(scaleOfScreen(1, 2560), 1);
  EXPECT_EQ(scaleOfScreen(1.5f, 3840), 1.5f) << "as the system tells";
}

}  // namespace
}  // namespace sonoskin::test
