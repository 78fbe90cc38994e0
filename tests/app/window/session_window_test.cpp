// Sessions in the window: saved when it is asked for before the program ends, opened again as the same picture, and restored
// after the program was killed.
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "app/workspace/session_actions.h"
#include "app/workspace/view_file.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

class SessionWindowTest : public WindowTest {
 protected:
  void makeSurface() {
    Driver& d = *driver;
    d.session().reconstruct();
    ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
    ASSERT_TRUE(d.waitUntilIdle());
  }
  // settle: until the skin's light is the final one.
  void settle() {
    Driver& d = *driver;
    ASSERT_TRUE(d.wait([&] { return d.workspace().view.skin.status.settled; }));
    d.frames(3);
  }
  void restart() {
    driver.reset();
    driver = std::make_unique<Driver>(smallPhantom());
  }
  static bool isTitled(const char* title) {
    return std::system(("xdotool search --name '^" + std::string(title) + "$' > /dev/null").c_str()) == 0;
  }
};

TEST_F(SessionWindowTest, IsSavedBeforeTheProgramEndsAndOpensAsTheSamePicture) {
  Driver* d = driver.get();
  ASSERT_TRUE(d->waitUntilIdle());
  d->frames(3);
  EXPECT_TRUE(isTitled("Sonoskin"));
  Parameters parameters = d->session().parameters();
  parameters.classification.alpha = 1.3;
  parameters.light.azimuth = 20;
  d->session().edit(parameters);
  d->session().commitEdit();
  ASSERT_TRUE(d->waitUntilIdle());
  makeSurface();
  EXPECT_TRUE(isTitled("● Sonoskin"));
  d->drag(d->point("pane.axial", 0.5f, 0.5f), d->point("pane.axial", 0.6f, 0.4f));
  d->drag(d->point("pane.space", 0.2f, 0.8f), d->point("pane.space", 0.3f, 0.75f));
  d->drag(d->point("pane.sagittal", 0.5f, 0.5f), d->point("pane.sagittal", 0.55f, 0.6f), 2);
  d->moveTo(d->point("surface.state"));
  settle();
  const Image before = d->screenshot("before");
  const std::string views = writeViews(d->workspace().view);

  d->press("ctrl+q");
  d->frames(3);
  ASSERT_TRUE(d->workspace().question);
  d->screenshot("sonoskin_unsaved");
  d->workspace().settings.folder = folder.path();
  d->click("question.save");
  d->frames(4);
  ASSERT_TRUE(d->workspace().files.purpose);
  EXPECT_FALSE(d->workspace().quit);
  d->press("Return");
  ASSERT_TRUE(d->wait([&] { return d->workspace().quit; }));
  ASSERT_TRUE(fs::exists(folder / "face.sonoskin"));

  restart();
  d = driver.get();
  EXPECT_FALSE(d->workspace().recovery) << "it ended as it should";
  openAny(d->workspace(), folder / "face.sonoskin");
  ASSERT_TRUE(d->wait([&] { return d->session().results().mesh && !d->session().activity().busy; }));
  d->moveTo(d->point("surface.state"));
  settle();
  EXPECT_EQ(writeViews(d->workspace().view), views);
  const Image after = d->screenshot("after");
  for (const char* pane : {"pane.axial", "pane.sagittal", "pane.coronal", "pane.space"})
    EXPECT_LT(difference(before, after, *d, pane), 0.004) << pane;  // outlines: see session_script.cpp
  EXPECT_FALSE(d->workspace().isModified());
}

// The program on a file, with nobody to end it properly.
class KilledWindowTest : public SessionWindowTest {
 protected:
  void SetUp() override {
    const fs::path volume = folder / "scan.nrrd";
    writeScan(volume, makePhantomScan(smallPhantom().phantom));
    setenv("XDG_STATE_HOME", (folder.path() / "state").c_str(), 1);
    setenv("XDG_CONFIG_HOME", (folder.path() / "settings").c_str(), 1);
    for (int moment = 0; moment < 3; ++moment) {
      killAfter(volume, 250'000 * moment);
      std::vector<AutosaveSlot> left = AutosaveSlot::left(folder / "state/sonoskin");
      ASSERT_EQ(left.size(), 1u) << moment;
      EXPECT_FALSE(leftText(left[0].file()).empty()) << moment;
      left[0].leave();
      if (moment < 2) fs::remove_all(folder / "state");
    }
    WindowTest::SetUp();
  }
  // killAfter: this long after it has kept the session for the first time.
  void killAfter(const fs::path& volume, useconds_t microseconds) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::execl(SONOSKIN_PROGRAM, SONOSKIN_PROGRAM, volume.c_str(), nullptr);
      ::_exit(127);
    }
    for (int n = 0; n < 3000 && !isKept(); ++n) ::usleep(10'000);
    EXPECT_TRUE(isKept());
    ::usleep(microseconds);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  bool isKept() const {
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder / "state/sonoskin", code))
      if (entry.path().extension() == ".sonoskin") return true;
    return false;
  }
};

TEST_F(KilledWindowTest, IsAskedOnceWhetherToRestore) {
  Driver* d = driver.get();
  d->frames(4);
  ASSERT_TRUE(d->workspace().recovery);
  d->screenshot("sonoskin_recovery");
  d->click("recovery.restore");
  ASSERT_TRUE(d->wait([&] { return d->session().source() == folder / "scan.nrrd"; }));
  ASSERT_TRUE(d->waitUntilIdle());
  EXPECT_TRUE(d->workspace().isModified()) << "nobody has saved it";
  restart();
  EXPECT_FALSE(driver->workspace().recovery);
}

}  // namespace
}  // namespace sonoskin
