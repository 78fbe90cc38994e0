// A volume in 3D with the real mouse: its colours, the handles of the crop box and the clip plane, and the turntable.
#include "app/workspace/commands.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

class VolumeWindowTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(driver->waitUntilIdle());
    driver->frames(3);
  }
};

TEST_F(VolumeWindowTest, APointOfTheColoursIsDragged) {
  Driver& d = *driver;
  command("view.colours").run(d.workspace());
  d.frames(20);
  const Image before = d.screenshot("before");
  const ImVec2 from = d.point("transfer.1");
  d.drag(from, {from.x + 60, from.y + 20});
  EXPECT_TRUE(d.workspace().view.volume.changed);
  d.frames(20);
  EXPECT_GT(difference(before, d.screenshot("after"), d, "pane.space"), 0.02);
}

TEST_F(VolumeWindowTest, ASideOfTheBoxAndThePlaneAreDragged) {
  Driver& d = *driver;
  d.workspace().view.camera.orbit(0.7f, 0.4f);
  d.frames(5);
  const ImVec2 side = d.point("crop.k+"), middle = d.point("pane.space");
  d.drag(side, {side.x + 0.2f * (middle.x - side.x), side.y + 0.2f * (middle.y - side.y)});
  EXPECT_GT(d.session().parameters().region.cutHigh[2], 1);
  EXPECT_TRUE(d.session().canUndo());
  ASSERT_TRUE(d.waitUntilIdle());

  d.press("g");
  EXPECT_TRUE(d.workspace().view.clip.on);
  d.frames(3);
  const float offset = d.workspace().view.clip.plane.offset;
  const ImVec2 handle = d.point("clip.handle");
  d.drag(handle, {handle.x, handle.y - 40});
  EXPECT_NE(d.workspace().view.clip.plane.offset, offset);
}

TEST_F(VolumeWindowTest, TheTurntableTurnsWhileItIsOn) {
  Driver& d = *driver;
  d.press("t");
  const glm::vec3 eye = d.workspace().view.camera.eye();
  d.frames(5);
  EXPECT_NE(d.workspace().view.camera.eye(), eye);
  d.press("t");
  const glm::vec3 rests = d.workspace().view.camera.eye();
  d.frames(5);
  EXPECT_EQ(d.workspace().view.camera.eye(), rests);
}

TEST_F(VolumeWindowTest, ATurntableIsSaved) {
  Driver& d = *driver;
  d.workspace().settings.folder = folder.path();
  d.workspace().pictureFormat = {{96, 80}, true, 3};
  command("file.saveTurntable").run(d.workspace());
  d.frames(3);
  d.click("picture.save");
  ASSERT_TRUE(d.workspace().files.purpose == ui::FilePurpose::saveTurntable);
  d.frames(4);
  d.press("Return");
  ASSERT_TRUE(d.wait([&] { return fs::exists(folder / "turntable_003.png"); }));
  EXPECT_EQ(readPng(folder / "turntable_001.png").rgba[3], 0) << "no background";
}

}  // namespace
}  // namespace sonoskin
