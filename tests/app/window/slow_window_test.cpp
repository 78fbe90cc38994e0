// Frames of 0.3 s, as where OpenGL is drawn in software or the machine is busy: nothing that a person does is lost.
#include <thread>

#include "core/base/error.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

class SlowWindowTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(driver->waitUntilIdle());
    ImGui::GetIO().MouseDoubleClickTime = 1;
  }
  // during: what xdotool does while one slow frame is drawn, and the frames after it.
  void during(const std::string& actions) {
    int status = -1;
    shown_ = 0;
    driver->loop.atFrame = [&] {
      if (shown_++ == 0) status = std::system(("xdotool " + actions).c_str());
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
    };
    driver->frames(4);
    ASSERT_EQ(status, 0) << actions;
    driver->loop.atFrame = {};
  }
  static std::string move(ImVec2 p) {
    return "mousemove " + std::to_string(int(p.x)) + " " + std::to_string(int(p.y)) + " ";
  }

  int shown_ = 0;  // frames, of the last during()
};

TEST_F(SlowWindowTest, PressAndMoveTakeTheLamp) {
  Driver& d = *driver;
  d.session().reconstruct();
  ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
  ASSERT_TRUE(d.waitUntilIdle());
  ASSERT_TRUE(d.wait([&] { return d.knows("lamp") && d.workspace().view.skin.status.milliseconds > 0; }));
  d.moveTo({5, 5});
  const LightOptions before = d.session().parameters().light;
  const Camera camera = d.workspace().view.camera;
  const ImVec2 from = d.point("lamp"), middle = d.point("pane.space");
  const ImVec2 to{middle.x + 0.8f * (middle.x - from.x), from.y};
  during(move(from) + "mousedown 1 " + move(to) + "mouseup 1");
  EXPECT_GT(d.session().parameters().light.azimuth, before.azimuth + 30);
  EXPECT_NEAR(d.point("lamp").x, to.x, 3) << "where it was let go";
  EXPECT_EQ(d.workspace().view.camera.forward, camera.forward) << "the view has turned instead";
}

TEST_F(SlowWindowTest, ADragEndsWhereItEnded) {
  Driver& d = *driver;
  const Geometry& g = d.session().scan().volume->geometry;
  const auto index = [&] { return g.toIndex(d.workspace().view.cursor); };
  const glm::dvec3 middle = index();
  d.moveTo(d.point("pane.axial"));
  d.mouse("mousedown 1");
  during(move(d.point("pane.axial", 0.6f, 0.4f)) + "mouseup 1 " + move({5, 5}));
  EXPECT_GT(index().x, middle.x + 5);
  EXPECT_LT(index().y, middle.y - 3);
}

TEST_F(SlowWindowTest, DoubleClicksAreThoseOfTheHand) {
  Driver& d = *driver;
  d.moveTo(d.point("pane.coronal"));
  during("click --repeat 2 --delay 60 1");
  EXPECT_EQ(d.workspace().view.maximised, Pane::coronal);
  during("key Escape");
  EXPECT_FALSE(d.workspace().view.maximised);
  during("click 1 sleep 1.5 click 1");
  EXPECT_FALSE(d.workspace().view.maximised) << "two clicks, a second and a half apart";
}

TEST_F(SlowWindowTest, WheelAndKeysKeepTheirOrder) {
  Driver& d = *driver;
  d.moveTo(d.point("pane.axial"));
  const double zoom = d.workspace().view.slices[std::size_t(Plane::axial)].zoom;
  const auto slice = [&] { return d.session().scan().volume->geometry.toIndex(d.workspace().view.cursor).z; };
  const double before = slice();
  const int first = ImGui::GetFrameCount();
  during("keydown ctrl click 4 keyup ctrl click 4 key 2 key v");
  EXPECT_GT(d.workspace().view.slices[std::size_t(Plane::axial)].zoom, zoom);
  EXPECT_NEAR(std::abs(slice() - before), 1, 1e-6);
  EXPECT_EQ(d.workspace().view.layer, SliceLayer::classified);
  EXPECT_GE(ImGui::GetFrameCount() - first, 8) << "one for each of them";
  EXPECT_LE(shown_, 5) << "those in between are not drawn";
}

TEST_F(SlowWindowTest, KeysReachTheDialogThatOpens) {
  Driver& d = *driver;
  d.session().reconstruct();
  ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
  d.workspace().settings.folder = folder.path();
  during("key ctrl+s key ctrl+a type --delay 1 rested");
  ASSERT_TRUE(d.workspace().files.purpose);
  during("key Return");
  EXPECT_FALSE(d.workspace().files.purpose);
  EXPECT_TRUE(d.wait([&] { return fs::exists(folder / "rested.recipe.json"); }, 20));
  EXPECT_TRUE(d.workspace().toasts.list.empty() || !d.workspace().toasts.list.front().failure);
}

// What the palette opens gets the keys in turn.
TEST_F(SlowWindowTest, KeysReachThePalette) {
  Driver& d = *driver;
  during("key ctrl+k type --delay 1 slicla");
  EXPECT_TRUE(d.workspace().help.paletteShown);
  EXPECT_TRUE(d.knows("palette.view.classified"));
  during("key Down key Up key Return");
  EXPECT_FALSE(d.workspace().help.paletteShown);
  EXPECT_EQ(d.workspace().view.layer, SliceLayer::classified);
  d.workspace().settings.folder = folder.path();
  during("key ctrl+k type --delay 1 savrec");
  during("key Return key ctrl+a type --delay 1 found");
  ASSERT_TRUE(d.workspace().files.purpose);
  EXPECT_EQ(d.workspace().files.name, "found");
  during("key Escape");
  EXPECT_FALSE(d.workspace().files.purpose);
  during("key ctrl+k key Escape");
  EXPECT_FALSE(d.workspace().help.paletteShown);
}

// A frame that fails is a message, and the next one follows.
TEST_F(SlowWindowTest, AFrameThatCannotBeginIsAMessage) {
  Driver& d = *driver;
  d.loop.atFrame = [] { throw Error("There is no memory for a frame."); };
  d.frames(2);
  d.loop.atFrame = {};
  d.frames(2);
  ASSERT_FALSE(d.workspace().toasts.list.empty());
  EXPECT_EQ(d.workspace().toasts.list.front().text, "There is no memory for a frame.");
  EXPECT_TRUE(d.alive());
}

}  // namespace
}  // namespace sonoskin
