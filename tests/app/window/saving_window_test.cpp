// Pictures and surfaces with skin are saved from every view, and the window goes on meanwhile.
#include <algorithm>

#include "render/gl/context.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

class SavingWindowTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(driver->waitUntilIdle());
  }
  void TearDown() override { EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError(); }
  void makeSurface() {
    Driver& d = *driver;
    d.session().reconstruct();
    ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
    ASSERT_TRUE(d.waitUntilIdle());
    ASSERT_TRUE(d.wait([&] { return d.workspace().view.skin.status.milliseconds > 0; }));
  }
  // save: through the dialog; the file's path. `longest_` of the frames until it is there, the one that takes the Return included, and `all_` their time.
  fs::path save(ui::FilePurpose purpose, const std::string& name) {
    Driver& d = *driver;
    d.workspace().files.ask(purpose, folder.path(), name);
    d.frames(4);
    EXPECT_EQ(std::system("xdotool keydown Return keyup Return"), 0);
    longest_ = all_ = 0;
    const Timer all;
    EXPECT_TRUE(d.wait([&] {
      const Timer frame;
      d.frames(1);
      longest_ = std::max(longest_, frame.seconds());
      return !d.workspace().files.purpose && !d.session().saving();
    }));
    all_ = all.seconds();
    EXPECT_TRUE(fs::exists(folder / name)) << name;
    return folder / name;
  }
  // How much of a picture is not its dark background.
  static double shown(const fs::path& path) {
    const Image image = readPng(path);
    EXPECT_EQ(image.width, 1280);
    int count = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) count += pixel(image, x, y).r > 70;
    return double(count) / (image.width * image.height);
  }

  double longest_ = 0, all_ = 0;
};

TEST_F(SavingWindowTest, PicturesOfAVolume) {
  EXPECT_GT(shown(save(ui::FilePurpose::savePicture, "surface.png")), 0.02);
  driver->workspace().view.volumeStyle = VolumeStyle::translucent;
  driver->frames(3);
  EXPECT_GT(shown(save(ui::FilePurpose::savePicture, "translucent.png")), 0.01);
  EXPECT_LT(longest_, 0.6 * all_) << "the window waits for the picture";
}

TEST_F(SavingWindowTest, PicturesOfASurface) {
  makeSurface();
  Driver& d = *driver;
  const double skin = shown(save(ui::FilePurpose::savePicture, "skin.png"));
  EXPECT_GT(skin, 0.05);
  EXPECT_LT(longest_, 0.6 * all_) << "the window waits for the picture";
  d.workspace().view.skin.compare = SkinCompare::settings;
  d.frames(3);
  EXPECT_NEAR(shown(save(ui::FilePurpose::savePicture, "halves.png")), skin, 0.02);
  d.press("m");
  EXPECT_GT(shown(save(ui::FilePurpose::savePicture, "clay.png")), 0.05);
}

TEST_F(SavingWindowTest, SurfacesWithSkinAndLight) {
  makeSurface();
  EXPECT_GT(fs::file_size(save(ui::FilePurpose::saveSkin, "skin.glb")), 100000u);
  EXPECT_GT(fs::file_size(save(ui::FilePurpose::saveLitSkin, "lit.glb")), 100000u);
  EXPECT_LT(longest_, 0.6 * all_) << "the window waits for the light";
}

}  // namespace
}  // namespace sonoskin
