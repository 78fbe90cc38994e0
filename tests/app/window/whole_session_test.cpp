// A session as a person has it, with the mouse and the keys of the display, from the first file to the same picture again: at
// the speed of the machine, and with frames of 0.3 s, where a whole gesture falls between two of them.
#include <thread>

#include "app/workspace/view_file.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

class WholeSessionTest : public WindowTest {
 protected:
  Driver& d() { return *driver; }
  ViewState& view() { return d().workspace().view; }
  const Parameters& parameters() { return d().session().parameters(); }

  // hand: what a person does at once, while one frame is drawn.
  void hand(const std::string& actions) {
    if (!slow_) {
      ASSERT_EQ(std::system(("xdotool " + actions).c_str()), 0) << actions;
    } else {
      int status = -1;
      d().application.atFrame = [&, shown = 0]() mutable {
        if (shown++ == 0) status = std::system(("xdotool " + actions).c_str());
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
      };
      d().frames(1);
      d().application.atFrame = [] { std::this_thread::sleep_for(std::chrono::milliseconds(300)); };
      ASSERT_EQ(status, 0) << actions;
    }
    d().frames(2);
    d().application.atFrame = {};
  }
  static std::string move(ImVec2 p) {
    return "mousemove " + std::to_string(int(p.x)) + " " + std::to_string(int(p.y)) + " ";
  }
  // stroke: the left button goes down at the first place and up at the last one.
  void stroke(const std::vector<ImVec2>& places) {
    std::string actions = move(places[0]) + "mousedown 1 ";
    for (const ImVec2& p : places) actions += move(p);
    hand(actions + "mouseup 1");
  }
  void click(const std::string& widget) { hand(move(d().point(widget)) + "click 1"); }
  void key(const std::string& keys) { hand("key " + keys); }
  // answer: a file dialog, by a name in the folder of the test.
  void answer(const std::string& name) {
    ASSERT_TRUE(d().workspace().files.purpose) << name;
    hand("key ctrl+a type --delay 1 " + (folder / name).string());
    key("Return");
    EXPECT_FALSE(d().workspace().files.purpose) << d().workspace().files.complaint;
  }
  void untilIdle() { ASSERT_TRUE(d().waitUntilIdle()); }

  void openAndTune();
  void cutAndUndo();
  void reconstruct();
  void measureAndSave();
  void quitAndReopen();
  void run(bool slow) {
    slow_ = slow;
    writeScan(folder / "scan.nrrd", makePhantomScan(smallPhantom().phantom));
    untilIdle();
    d().workspace().settings.folder = folder.path();
    for (const auto part :
         {&WholeSessionTest::openAndTune, &WholeSessionTest::cutAndUndo, &WholeSessionTest::reconstruct,
          &WholeSessionTest::measureAndSave, &WholeSessionTest::quitAndReopen}) {
      (this->*part)();
      if (HasFatalFailure()) return;
    }
  }

  bool slow_ = false;
};

void WholeSessionTest::openAndTune() {
  const auto opened = d().session().opened();
  key("ctrl+o");
  answer("scan.nrrd");
  ASSERT_TRUE(d().wait([&] { return d().session().opened() != opened; }));
  untilIdle();
  const glm::dvec3 cursor = view().cursor;
  stroke({d().point("pane.axial", 0.5f, 0.5f), d().point("pane.axial", 0.55f, 0.45f)});
  EXPECT_NE(view().cursor, cursor);

  click("step.classify");
  const auto values = [&] {
    const ClassificationOptions& c = parameters().classification;
    return std::array{c.isoValue, c.alpha, c.beta, c.gamma};
  };
  const auto before = values();
  for (const char* name : {"isoValue", "alpha", "beta", "gamma"}) {
    const std::string row = std::string("classification.") + name;
    stroke({d().point(row, 0.4f), d().point(row, 0.45f)});
  }
  for (std::size_t n = 0; n < 4; ++n) EXPECT_NE(values()[n], before[n]) << n;
  untilIdle();
}

void WholeSessionTest::cutAndUndo() {
  const ErasedParts& erased = d().session().erased();
  click("step.region");
  const auto cut = parameters().region.cutHigh;
  if (!d().knows("region.k.high")) click("foldout.Crop box");
  stroke({d().point("region.k.high", 0.97f), d().point("region.k.high", 0.9f)});
  EXPECT_NE(parameters().region.cutHigh, cut) << "crop";
  key("e");
  stroke({d().point("pane.axial", 0.45f, 0.4f), d().point("pane.axial", 0.5f, 0.45f)});
  const std::size_t dab = erased.voxels();
  EXPECT_GT(dab, 0u) << "erase";
  key("x");
  const auto at = [&](float x, float y) { return d().point("pane.space", x, y); };
  stroke({at(0.1f, 0.3f), at(0.25f, 0.3f), at(0.25f, 0.45f), at(0.1f, 0.45f)});
  const std::size_t both = erased.voxels();
  EXPECT_GT(both, dab) << "lasso";
  key("Escape");
  key("ctrl+z");
  EXPECT_EQ(erased.voxels(), dab) << "undo";
  key("ctrl+shift+z");
  EXPECT_EQ(erased.voxels(), both) << "redo";
  untilIdle();
}

void WholeSessionTest::reconstruct() {
  key("ctrl+Return");
  ASSERT_TRUE(d().session().activity().busy);
  key("Escape");
  ASSERT_TRUE(d().wait([&] { return !d().session().activity().busy; }));
  EXPECT_EQ(d().session().state(), DocumentState::stopped);
  const auto made = d().session().reconstructions();
  key("ctrl+Return");
  ASSERT_TRUE(d().wait([&] { return d().session().reconstructions() > made; }));
  untilIdle();
  key("p");
  ASSERT_TRUE(view().parts);
  const auto kept = [&] {
    return std::ranges::count_if(*d().session().results().verdicts, &PartVerdict::kept);
  };
  const auto before = kept();
  hand(move(d().point("pane.space", 0.5f, 0.25f)) + "click 1");
  untilIdle();
  EXPECT_EQ(kept(), before - 1) << "a part is taken away";
  key("Escape");
  untilIdle();
}

void WholeSessionTest::measureAndSave() {
  key("d");
  hand(move(d().point("pane.axial", 0.4f, 0.4f)) + "click 1");
  hand(move(d().point("pane.axial", 0.5f, 0.5f)) + "click 1");
  EXPECT_EQ(view().measures.size(), 1u) << "measure";
  key("Escape");
  key("F12");
  click("picture.save");
  d().frames(3);
  answer("picture.png");
  ASSERT_TRUE(d().wait([&] { return fs::exists(folder / "picture.png"); }));
  key("ctrl+s");
  answer("face.ply");
  ASSERT_TRUE(d().wait([&] { return fs::exists(folder / "face.recipe.json") && !d().session().saving(); }));
}

void WholeSessionTest::quitAndReopen() {
  view().meshStyle = MeshStyle::clay;  // whose picture does not wait for its light
  d().frames(2);                       // what was saved is noted
  EXPECT_FALSE(d().session().hasUnsavedWork());
  click("step.classify");
  stroke({d().point("classification.beta", 0.45f), d().point("classification.beta", 0.4f)});
  untilIdle();
  key("ctrl+q");
  ASSERT_TRUE(d().workspace().question) << "asked before the session is lost";
  const std::string views = writeViews(view());
  hand(move({5, 5}));
  click("question.save");
  d().frames(3);
  answer("whole.sonoskin");
  ASSERT_TRUE(d().wait([&] { return d().workspace().quit; }));
  driver.reset();
  driver = std::make_unique<Driver>(smallPhantom());
  untilIdle();
  d().workspace().settings.folder = folder.path();
  key("ctrl+o");
  answer("whole.sonoskin");
  ASSERT_TRUE(d().wait([&] { return d().session().results().mesh && !d().session().activity().busy; }));
  EXPECT_EQ(writeViews(view()), views);
  EXPECT_EQ(view().measures.size(), 1u);
  EXPECT_GT(d().session().erased().voxels(), 0u);
}

TEST_F(WholeSessionTest, AtTheSpeedOfTheMachine) { run(false); }

TEST_F(WholeSessionTest, WithFramesOfThreeTenthsOfASecond) { run(true); }

}  // namespace
}  // namespace sonoskin
