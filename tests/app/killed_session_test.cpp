// The program killed at ten moments of a session, one run after the other: each start asks whether to restore, goes on from what
// was kept, and is killed again. What is killed is this test program, run with a number: the application without a window.
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string_view>
#include <thread>

#include "app/workspace/view_file.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/mesh_reader.h"
#include "tests/app/injected_player.h"
#include "tests/app/session_script.h"
#include "tests/support/temp_folder.h"

namespace sonoskin::test {
namespace {

namespace fs = std::filesystem;

constexpr const char *kRun = "SONOSKIN_KILLED_RUN", *kFolder = "SONOSKIN_KILLED_FOLDER";

// A run: plays pieces of the script, and is killed.
//   upTo  the pieces played by then
//   last  what it is killed in the middle of; none: at rest, once a minute of change is over
struct Run {
  const char* name;
  std::size_t upTo;
  void (*last)(InjectedPlayer&) = nullptr;
};

// A run that has failed ends otherwise, so that the first one sees it.
[[noreturn]] void die() {
  if (testing::Test::HasFailure()) ::_exit(1);
  ::kill(::getpid(), SIGKILL);
  std::abort();
}

// Everything that is open, as it is kept.
std::string present(Player& p) { return writeSessionFile(p.session().capture(writeViews(p.view()))()); }

std::string kept(Player& p) {
  std::error_code code;
  const fs::path file = p.application().autosave().file();
  return fs::exists(file, code) ? readText(file, kMostSessionBytes) : std::string();
}

// What the next run may find, of two moments.
void expect(Player& p, const std::string& first, const std::string& second) {
  writeBytes(p.folder / "expected.0", first.data(), first.size());
  writeBytes(p.folder / "expected.1", second.data(), second.size());
}

// A minute of change is over: what is open is kept.
void untilKept(Player& p) {
  p.application().autosave().seconds = 0;
  ASSERT_TRUE(p.wait([&] { return kept(p) == present(p); }));
  p.application().autosave().seconds = 60;
}

void change(Player& p) {
  p.click("step.classify");
  p.stroke({p.point("classification.alpha", 0.5f), p.point("classification.alpha", 0.55f)});
  ASSERT_TRUE(p.untilIdle());
}

// The change is no minute old, but long work keeps it before it begins.
void inAReconstruction(InjectedPlayer& p) {
  change(p);
  const std::string asked = present(p);
  ASSERT_NE(kept(p), asked);
  expect(p, asked, asked);
  const auto made = p.session().reconstructions();
  p.atFrame = [&] {
    ASSERT_EQ(p.session().reconstructions(), made) << "it was too fast to be killed";
    if (p.session().activity().fraction > 0.2 && kept(p) == asked) die();
  };
  p.key("ctrl+Return");
  p.wait([] { return false; });
}

void inSavingTheMesh(InjectedPlayer& p) {
  ASSERT_NO_FATAL_FAILURE(untilKept(p));
  expect(p, kept(p), kept(p));
  p.atFrame = [&p] {
    if (p.session().saving()) die();
  };
  sessionScript().back().play(p);
}

// Killed as soon as the file is being written: it is the one before, or whole.
void inKeeping(InjectedPlayer& p) {
  ASSERT_NO_FATAL_FAILURE(untilKept(p));
  const std::string before = kept(p);
  change(p);
  expect(p, before, present(p));
  std::thread([state = p.application().autosave().file().parent_path()] {
    for (;;) {
      std::error_code code;
      for (const auto& entry : fs::directory_iterator(state, code))
        if (entry.path().filename().string().starts_with(".sonoskin-")) die();
    }
  }).detach();
  p.application().autosave().seconds = 0;
  p.wait([] { return false; });
}

constexpr std::array<Run, 10> kRuns{{{"tuning", 3},
                                     {"crop", 4},
                                     {"erase", 5},
                                     {"lasso", 6},
                                     {"during a reconstruction", 7, inAReconstruction},
                                     {"reconstructed", 8},
                                     {"a part taken away", 9},
                                     {"measured", 10},
                                     {"while the mesh is saved", 11, inSavingTheMesh},
                                     {"while it is kept", 11, inKeeping}}};

// Restored is what the run before had, and it is asked for again if this one is killed.
void restore(Player& p) {
  p.frames(3);
  ASSERT_TRUE(p.workspace().recovery) << "nothing is offered";
  p.click("recovery.restore");
  ASSERT_TRUE(p.wait([&] { return p.session().source() == p.folder / "scan.nrrd"; }));
  ASSERT_TRUE(p.untilIdle());
  p.frames(2);
  const std::string restored = present(p);
  const std::string first = readText(p.folder / "expected.0"), second = readText(p.folder / "expected.1");
  EXPECT_TRUE(restored == first || restored == second) << restored << "\ninstead of\n" << first;
  EXPECT_TRUE(p.workspace().isModified()) << "nobody has saved it";
}

void play(std::size_t run) {
  InjectedPlayer p(scriptParameters());
  p.folder = std::getenv(kFolder);
  if (run == 0)
    beginScript(p);
  else
    ASSERT_NO_FATAL_FAILURE(restore(p));
  p.workspace().settings.folder = p.folder;
  if (run == kRuns.size()) return;
  for (std::size_t n = run == 0 ? 0 : kRuns[run - 1].upTo; n < kRuns[run].upTo; ++n) {
    SCOPED_TRACE(sessionScript()[n].name);
    ASSERT_NO_FATAL_FAILURE(sessionScript()[n].play(p));
  }
  if (testing::Test::HasFailure()) return;
  if (kRuns[run].last) return kRuns[run].last(p);
  ASSERT_NO_FATAL_FAILURE(untilKept(p));
  expect(p, kept(p), kept(p));
  die();
}

// How it ended, as waitpid() has it.
int start(std::size_t run, const fs::path& folder) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    setenv(kRun, std::to_string(run).c_str(), 1);
    setenv(kFolder, folder.c_str(), 1);
    const fs::path program = fs::read_symlink("/proc/self/exe");
    ::execl(program.c_str(), program.c_str(), "--gtest_filter=KilledSession.*", nullptr);
    ::_exit(127);
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return status;
}

TEST(KilledSession, IsRestoredAtTenMoments) {
  if (const char* run = std::getenv(kRun)) return play(std::size_t(std::atoi(run)));
  const TempFolder folder;
  setenv("XDG_CONFIG_HOME", (folder.path() / "settings").c_str(), 1);
  setenv("XDG_STATE_HOME", (folder.path() / "state").c_str(), 1);
  for (std::size_t run = 0; run < kRuns.size(); ++run) {
    const int status = start(run, folder.path());
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << kRuns[run].name;
  }
  const int status = start(kRuns.size(), folder.path());
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "the last one, which ends as it should";
  int left = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder / "state/sonoskin")) ++left;
  EXPECT_EQ(left, 0) << "nothing is left to be asked for";
  const fs::path mesh = folder / "face.ply";
  EXPECT_TRUE(!fs::exists(mesh) || !readMesh(mesh).triangles.empty()) << "half a file";
}

}  // namespace
}  // namespace sonoskin::test
