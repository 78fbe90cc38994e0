// What a hand does with each tool during one frame that takes long: it goes down, along its way and up again before the next
// frame begins, and nothing of it is lost.
#include "app/document/crop_box.h"
#include "app/workspace/commands.h"
#include "tests/app/injected_player.h"
#include "tests/app/session_script.h"
#include "tests/support/temp_folder.h"

namespace sonoskin::test {
namespace {

class Gestures : public testing::Test {
 protected:
  Gestures() {
    setenv("XDG_CONFIG_HOME", (folder_.path() / "settings").c_str(), 1);
    setenv("XDG_STATE_HOME", (folder_.path() / "state").c_str(), 1);
    player_.emplace(scriptParameters());
  }
  void SetUp() override { ASSERT_TRUE(p().untilIdle()); }
  void TearDown() override { EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError(); }

  Player& p() { return *player_; }
  ViewState& view() { return p().view(); }
  const RegionOptions& region() { return p().session().parameters().region; }
  // drag: from the middle of a widget, by so many pixels.
  void drag(const std::string& widget, float x, float y) {
    const ImVec2 from = p().point(widget);
    p().stroke({from, {from.x + 0.5f * x, from.y + 0.5f * y}, {from.x + x, from.y + y}});
  }

 private:
  const TempFolder folder_;
  std::optional<InjectedPlayer> player_;
};

TEST_F(Gestures, InSlices) {
  const glm::dvec3 cursor = view().cursor;
  p().key("d");
  p().stroke({p().point("pane.axial", 0.4f, 0.4f), p().point("pane.axial", 0.5f, 0.45f),
              p().point("pane.axial", 0.6f, 0.5f)});
  ASSERT_EQ(view().measures.size(), 1u) << "a distance by one drag";
  EXPECT_EQ(view().measures[0].marks.size(), 2u);
  EXPECT_EQ(view().cursor, cursor) << "the cross-hair has moved instead";
  p().key("Escape");

  p().key("e");
  p().stroke({p().point("pane.coronal", 0.3f, 0.5f), p().point("pane.coronal", 0.5f, 0.5f),
              p().point("pane.coronal", 0.5f, 0.7f)});
  const std::size_t corner = p().session().erased().voxels();
  p().key("ctrl+z");
  p().stroke({p().point("pane.coronal", 0.3f, 0.5f), p().point("pane.coronal", 0.5f, 0.7f)});
  EXPECT_GT(corner, p().session().erased().voxels()) << "the stroke has taken the short way";
  p().key("Escape");
}

TEST_F(Gestures, InThreeDimensions) {
  view().camera.orbit(0.7f, 0.4f);
  view().cameraMoved = true;
  p().frames(3);
  const Camera camera = view().camera;
  const ImVec2 side = p().point("crop.k+"), middle = p().point("pane.space");
  drag("crop.k+", 0.2f * (middle.x - side.x), 0.2f * (middle.y - side.y));
  EXPECT_GT(region().cutHigh[2], 1) << "the handle of the crop box";
  ASSERT_TRUE(p().untilIdle());

  p().key("g");
  p().frames(3);
  const float offset = view().clip.plane.offset;
  drag("clip.handle", 0, -40);
  EXPECT_NE(view().clip.plane.offset, offset) << "the clip plane";
  p().key("g");

  p().key("x");
  const auto at = [&](float x, float y) { return p().point("pane.space", x, y); };
  p().stroke({at(0.4f, 0.4f), at(0.6f, 0.4f), at(0.6f, 0.6f), at(0.4f, 0.6f)});
  EXPECT_GT(p().session().erased().voxels(), 0u) << "the lasso";
  EXPECT_EQ(view().camera.forward, camera.forward) << "the view has turned instead";
}

TEST_F(Gestures, InTheWindow) {
  const float across = p().workspace().settings.layout.across;
  drag("divider.across", 80, 0);
  EXPECT_GT(p().workspace().settings.layout.across, across + 0.03f) << "a divider";
  command("view.colours").run(p().workspace());
  p().frames(5);
  drag("transfer.1", 60, 20);
  EXPECT_TRUE(view().volume.changed) << "a point of the colours";
  p().click("step.classify");
  const double beta = p().session().parameters().classification.beta;
  p().stroke({p().point("classification.beta", 0.4f), p().point("classification.beta", 0.8f)});
  EXPECT_NE(p().session().parameters().classification.beta, beta) << "a slider";
  ASSERT_TRUE(p().untilIdle());
}

// Press and release of one widget, then of another, all before the first is seen.
TEST_F(Gestures, ClicksInARow) {
  p().hand({moveTo(p().point("step.region")), press(), release(), moveTo(p().point("step.skin")), press(),
            release(), keyPress("ctrl+3"), keyPress("2")});
  EXPECT_EQ(p().workspace().step, Step::classify);
  EXPECT_EQ(view().layer, SliceLayer::classified);
}

}  // namespace
}  // namespace sonoskin::test
