// What is kept in case the program ends unexpectedly.
#include "app/workspace/autosave.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "app/document/input.h"
#include "app/workspace/commands.h"
#include "app/workspace/session_actions.h"
#include "app/workspace/workspace.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/private_file.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/app/session_support.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;
using test::tinySurface;
using test::wait;

TEST(AutosaveSlot, GoesWithAProgramThatEndsAsItShould) {
  const TempFolder folder;
  {
    const AutosaveSlot slot(folder.path());
    writePrivately(slot.file(), "{}");
    EXPECT_TRUE(AutosaveSlot::left(folder.path()).empty()) << "its program lives";
    struct stat facts {};
    ASSERT_EQ(::stat(slot.file().c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777, 0600u);
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(AutosaveSlot, WhatIsOldOrEmptyIsTakenAway) {
  const TempFolder folder;
  AutosaveSlot old(folder.path()), empty(folder.path()), whole(folder.path());
  for (AutosaveSlot* slot : {&old, &whole}) writePrivately(slot->file(), "{}");
  fs::last_write_time(old.file(), fs::file_time_type::clock::now() - std::chrono::hours(24 * 40));
  for (AutosaveSlot* slot : {&old, &empty, &whole}) slot->leave();
  std::vector<AutosaveSlot> left = AutosaveSlot::left(folder.path());
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].file(), whole.file());
  EXPECT_EQ(folder.entries(), 2);
  left[0].leave();
  EXPECT_EQ(AutosaveSlot::left(folder.path()).size(), 1u) << "it may be asked for later";
}

// It may be of a newer version, which will read it.
TEST(AutosaveSlot, WhatCannotBeReadStaysAndIsNamed) {
  const TempFolder folder;
  AutosaveSlot damaged(folder.path()), whole(folder.path());
  SessionFile session;
  session.volume = kPhantomInput;
  session.recipe = writeRecipe({});
  const std::string text = writeSessionFile(session);
  writePrivately(whole.file(), text);
  writePrivately(damaged.file(), text.substr(0, text.size() / 2));
  const fs::path file = damaged.file();
  for (AutosaveSlot* slot : {&damaged, &whole}) slot->leave();
  const LogRecord record;
  {
    const std::vector<AutosaveSlot> left = readableLeft(folder.path());
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].file(), whole.file());
  }
  EXPECT_FALSE(fs::exists(whole.file())) << "it was answered";
  EXPECT_EQ(readText(file, kMostSessionBytes), text.substr(0, text.size() / 2));
  const auto told = record.sentences(LogLevel::warning);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find(file.string()), std::string::npos);
}

// A program that saves, over and over, sessions that tell twice which one they are.
[[noreturn]] void saveUntilKilled(const fs::path& folder) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const AutosaveSlot slot(folder);
  for (int n = 1;; ++n) {
    SessionFile session;
    session.volume = std::to_string(n);
    session.recipe = writeRecipe({});
    session.views = "{\"n\":" + std::to_string(n) + ",\"long\":\"" +
                    std::string(std::size_t(n % 7) * 100'000, 'x') + "\"}";
    writePrivately(slot.file(), writeSessionFile(session));
  }
}

TEST(AutosaveSlot, IsWholeWheneverTheProgramIsKilled) {
  for (int moment = 0; moment < 10; ++moment) {
    SCOPED_TRACE(moment);
    const TempFolder folder;
    const pid_t child = ::fork();
    if (child == 0) saveUntilKilled(folder.path());
    const auto saved = [&] {
      for (const auto& entry : fs::directory_iterator(folder.path()))
        if (entry.path().extension() == ".sonoskin") return true;
      return false;
    };
    for (int n = 0; n < 5000 && !saved(); ++n) ::usleep(1000);
    ::usleep(useconds_t(3100 * moment));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    std::vector<AutosaveSlot> left = AutosaveSlot::left(folder.path());
    ASSERT_EQ(left.size(), 1u);
    const SessionFile session = readSessionFile(readText(left[0].file(), kMostSessionBytes));
    EXPECT_EQ(session.views.find("\"n\":" + session.volume.string()), session.views.find("\"n\":"));
    EXPECT_FALSE(leftText(left[0].file()).empty());
  }
}

// A workspace on a file, and what is kept of it.
struct Kept {
  const TempFolder folder;
  const fs::path state = folder / "state", volume = folder / "scan.nrrd";
  Workspace workspace{tinySurface()};
  Autosave autosave{state};

  Kept() {
    setenv("XDG_CONFIG_HOME", (folder.path() / "settings").c_str(), 1);
    writeScan(volume, makePhantomScan(tinySurface().phantom));
  }
  Session& session() { return workspace.session; }
  // look: until what it writes is there.
  void look() {
    autosave.look(workspace);
    for (int n = 0; n < 500 && !hasFile(); ++n) ::usleep(2000);
  }
  bool hasFile() const { return !autosave.file().empty() && fs::exists(autosave.file()); }
  SessionFile file() const { return readSessionFile(readText(autosave.file(), kMostSessionBytes)); }
  void edit(double alpha) {
    Parameters parameters = session().parameters();
    parameters.classification.alpha = alpha;
    session().edit(parameters);
    session().commitEdit();
    ASSERT_TRUE(wait(session()));
  }
};

TEST(Autosave, AnUntouchedPhantomIsNoLoss) {
  Kept kept;
  kept.session().openPhantom();
  ASSERT_TRUE(wait(kept.session()));
  kept.autosave.look(kept.workspace);
  EXPECT_TRUE(kept.autosave.file().empty());
  kept.edit(2);
  kept.session().reconstruct();  // before work that takes long
  kept.look();
  ASSERT_TRUE(kept.hasFile());
  Parameters read;
  readRecipe(kept.file().recipe, read);
  EXPECT_EQ(read.classification.alpha, 2);
  EXPECT_EQ(kept.file().volume, "phantom");
}

TEST(Autosave, KeepsAFileThatWasOpenedAndWhatIsMadeOfIt) {
  Kept kept;
  kept.session().openFile(kept.volume);
  ASSERT_TRUE(wait(kept.session()));
  kept.look();
  ASSERT_TRUE(kept.hasFile());
  EXPECT_EQ(kept.file().volume, kept.volume);
  kept.edit(3);
  kept.autosave.seconds = 0;
  const auto alpha = [&] {
    Parameters read;
    readRecipe(kept.file().recipe, read);
    return read.classification.alpha;
  };
  for (int n = 0; n < 1000 && alpha() != 3; ++n) {
    kept.autosave.look(kept.workspace);
    ::usleep(5000);
  }
  EXPECT_EQ(alpha(), 3);
}

TEST(Autosave, HoldsNoPathWhereFilesAreNotRemembered) {
  Kept kept;
  kept.workspace.settings.remembersFiles = false;
  kept.session().openFile(kept.volume);
  ASSERT_TRUE(wait(kept.session()));
  kept.look();
  ASSERT_TRUE(kept.hasFile());
  EXPECT_EQ(readText(kept.autosave.file(), kMostSessionBytes).find("scan.nrrd"), std::string::npos);
}

// Only what has opened is worth remembering, and it is remembered at once.
TEST(RecentFiles, AreWrittenWhenTheyOpen) {
  Kept kept;
  openAny(kept.workspace, kept.folder / "missing.nrrd");
  ASSERT_TRUE(wait(kept.session()));
  takeInOpened(kept.workspace);
  EXPECT_TRUE(kept.workspace.settings.recent.empty());
  openAny(kept.workspace, kept.volume);
  ASSERT_TRUE(wait(kept.session()));
  takeInOpened(kept.workspace);
  ASSERT_EQ(readSettings(settingsFile()).recent.size(), 1u);
  EXPECT_EQ(readSettings(settingsFile()).recent[0], kept.volume);
}

TEST(SessionActions, ACursorOutsideOfTheVolumeComesIntoIt) {
  Kept kept;
  Workspace& w = kept.workspace;
  SessionFile session;
  session.volume = kPhantomInput;
  session.recipe = writeRecipe(tinySurface());
  session.views = R"({"cursor": [1e308, 0, 0]})";
  w.session.openSession(kept.folder.write("far.sonoskin", writeSessionFile(session)));
  ASSERT_TRUE(wait(w.session));
  takeInOpened(w);
  const Geometry& g = w.session.scan().volume->geometry;
  const glm::dvec3 index = g.toIndex(w.view.cursor);
  for (int i = 0; i < 3; ++i) {
    EXPECT_GE(index[i], -1e-6);
    EXPECT_LE(index[i], g.dims[i] - 1 + 1e-6);
  }
}

TEST(Dropped, FilesAreToldApart) {
  Kept kept;
  Workspace& w = kept.workspace;
  takeDropped(w, {kept.volume, kept.volume});
  EXPECT_EQ(w.dropped.size(), 2u);
  EXPECT_TRUE(w.isAsked());
  w.dropQuestions();
  takeDropped(w, {kept.folder.write("face.ply", "ply\n")});
  ASSERT_EQ(w.toasts.list.size(), 1u);
  EXPECT_NE(w.toasts.list[0].text.find("is a surface"), std::string::npos);
  takeDropped(w, {kept.volume});
  ASSERT_TRUE(wait(w.session));
  EXPECT_EQ(w.session.source(), kept.volume);
  Parameters other = w.session.parameters();
  other.classification.alpha = 2.25;
  takeDropped(w, {kept.folder.write("a.recipe.json", writeRecipe(other))});
  ASSERT_TRUE(wait(w.session));
  EXPECT_EQ(w.session.parameters().classification.alpha, 2.25);
  takeDropped(w, {kept.folder.write("a.sonoskin", "{}")});
  EXPECT_TRUE(w.question) << "the recipe's parameters are not saved";
}

// Each of what would put something else in the document's place.
TEST(Unsaved, NothingGoesWithoutAQuestion) {
  Kept kept;
  Workspace& w = kept.workspace;
  kept.session().openFile(kept.volume);
  ASSERT_TRUE(wait(kept.session()));
  kept.edit(2);
  const std::uint64_t opened = w.session.opened();
  const std::function<void()> ways[] = {[&] { openAny(w, kept.volume); },
                                        [&] { takeDropped(w, {kept.volume}); },
                                        [&] { openAny(w, kept.folder / "a.sonoskin"); },
                                        [&] { openRecipe(w, kept.folder / "a.recipe.json"); },
                                        [&] { command("file.phantom").run(w); },
                                        [&] { command("edit.reset").run(w); },
                                        [&] { command("file.quit").run(w); }};
  for (std::size_t n = 0; n < std::size(ways); ++n) {
    ways[n]();
    EXPECT_TRUE(w.question) << n;
    w.question.reset();
  }
  ASSERT_TRUE(wait(kept.session()));
  EXPECT_EQ(w.session.opened(), opened);
  EXPECT_EQ(w.session.parameters().classification.alpha, 2);

  // Saved first, and then done; marks of measures too.
  w.session.undo();
  EXPECT_FALSE(w.isModified());
  w.view.measures.push_back({MeasureKind::distance, {{0, 0, 0}, {1, 2, 3}}});
  EXPECT_TRUE(w.isModified());
  command("file.quit").run(w);
  w.sessionFile = kept.folder / "a.sonoskin";
  saveSession(w, std::exchange(w.question, std::nullopt)->action);
  EXPECT_FALSE(w.quit);
  ASSERT_TRUE(wait(kept.session()));
  EXPECT_TRUE(w.quit);
  EXPECT_TRUE(fs::exists(kept.folder / "a.sonoskin"));
  EXPECT_FALSE(w.isModified());
}

}  // namespace
}  // namespace sonoskin
