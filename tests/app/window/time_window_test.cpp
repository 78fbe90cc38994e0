// A recording in time: slider, play, and a mesh of each step.
#include "tests/app/window/window_driver.h"
#include "tests/support/program.h"
#include "tests/support/recording.h"

namespace sonoskin {
namespace {

class TimeWindowTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(driver->waitUntilIdle());
    PhantomOptions phantom = smallPhantom().phantom;
    phantom.dims = {117, 64, 31};
    test::writeRecording(folder / "three.nrrd", phantom, 3);
    driver->workspace().open(folder / "three.nrrd");
    ASSERT_TRUE(driver->wait([&] { return driver->session().scan().timeSteps == 3; }));
    ASSERT_TRUE(driver->waitUntilIdle());
    driver->frames(3);
  }
};

TEST_F(TimeWindowTest, SliderPlayAndSequence) {
  Driver& d = *driver;
  d.moveTo(d.point("volume.time", 0.98f));
  d.mouse("mousedown 1");
  d.mouse("mouseup 1");
  ASSERT_TRUE(d.wait([&] { return d.session().scan().time == 3; }));
  d.press("comma");
  ASSERT_TRUE(d.wait([&] { return d.session().scan().time == 2; }));
  ASSERT_TRUE(d.waitUntilIdle());

  d.session().reconstruct();
  ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
  ASSERT_TRUE(d.waitUntilIdle());
  d.frames(5);
  const Image before = d.screenshot("second");
  d.click("volume.play");
  EXPECT_TRUE(d.workspace().play.on);
  std::array<bool, 4> seen{};
  ASSERT_TRUE(d.wait([&] {
    seen[std::size_t(d.session().scan().time)] = true;
    return seen[1] && seen[2] && seen[3] && d.session().scan().time == 1;
  }));
  d.press("space");
  EXPECT_FALSE(d.workspace().play.on);
  ASSERT_TRUE(d.waitUntilIdle());
  EXPECT_EQ(d.workspace().view.content, SpaceContent::mesh) << "a step is no other document";
  EXPECT_TRUE(d.session().meshIsCurrent());
  const Image after = d.screenshot("another");
  EXPECT_GT(difference(before, after, d, "pane.axial"), 0.005) << "the slices show another step";

  d.workspace().play.first = 2;
  d.workspace().files.ask(ui::FilePurpose::saveSequence, folder.path(), "face.stl");
  d.frames(4);
  EXPECT_EQ(std::system("xdotool keydown Return keyup Return"), 0);
  ASSERT_TRUE(d.wait([&] { return fs::exists(folder / "face.recipe.json"); }));
  EXPECT_FALSE(fs::exists(folder / "face_0001.stl"));
  EXPECT_TRUE(fs::exists(folder / "face_0002.stl"));
  EXPECT_TRUE(fs::exists(folder / "face_0003.stl"));
}

}  // namespace
}  // namespace sonoskin
