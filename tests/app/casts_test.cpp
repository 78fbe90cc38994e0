// The layout that compares ray-casts, drawn without a window.
#include <algorithm>

#include "app/views/four_up.h"
#include "app/workspace/commands.h"
#include "render/gl/context.h"
#include "render/gl/read_pixels.h"
#include "tests/app/session_support.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

class Casts : public ImGuiTest {
 protected:
  Casts() : ImGuiTest({640, 480}), workspace(test::tinyPhantom()) {}

  void SetUp() override {
    ImGuiTest::SetUp();
    context_->makeCurrent();
    workspace.session.openPhantom();
    ASSERT_TRUE(test::wait(workspace.session));
    ASSERT_TRUE(workspace.session.results().thinned);
    resetView(workspace.view, workspace.session.scan(), workspace.session.beam());
    workspace.lookAtFace();
  }
  void frame() {
    ImGui::GetIO().DeltaTime = 0.05f;
    beginFrame();
    next = drawFourUp(views, workspace);
    ImGui::End();
    ImGui::Render();
  }
  // Frames until all pictures are final.
  bool settle() {
    for (int n = 0; n < 200; ++n) {
      frame();
      if (next != 0) return true;
    }
    return false;
  }
  SpaceWindow& cast(SliceLayer layer) { return (*views.casts)[std::size_t(layer)]; }
  // The share of a picture's pixels that show something: brighter than its darkest ones.
  static double seen(const SpaceWindow& window) {
    const Image image = gl::readImage(window.picture);
    std::vector<std::uint8_t> greens;
    for (std::size_t p = 1; p < image.rgba.size(); p += 4) greens.push_back(image.rgba[p]);
    return double(std::ranges::count_if(greens, [](int g) { return g > 70; })) / double(greens.size());
  }

 private:
  std::unique_ptr<gl::Context> context_ = gl::makeOffscreenContext(gl::Backend::egl);

 protected:
  Workspace workspace;
  FourUp views;
  double next = -1;
};

TEST_F(Casts, ShowTheThreeVolumesEachInItsOwnWay) {
  command("layout.casts").run(workspace);
  for (const VolumeStyle style : {VolumeStyle::surface, VolumeStyle::translucent, VolumeStyle::maximum}) {
    workspace.view.comparedStyle = style;
    ASSERT_TRUE(settle());
    for (const SliceLayer layer : {SliceLayer::raw, SliceLayer::classified, SliceLayer::thinned}) {
      const SpaceWindow& window = cast(layer);
      EXPECT_EQ(window.state.sampling, PictureState::Sampling::full);
      EXPECT_GT(seen(window), 0.01) << int(style) << " " << layerName(layer);
    }
    EXPECT_NE(gl::readImage(cast(SliceLayer::raw).picture).rgba,
              gl::readImage(cast(SliceLayer::thinned).picture).rgba);
  }
}

TEST_F(Casts, HaveOneCameraAndMoveTogether) {
  command("layout.casts").run(workspace);
  ASSERT_TRUE(settle());
  std::array<Key, 3> before;
  for (std::size_t n = 0; n < 3; ++n) before[n] = (*views.casts)[n].drawn;
  workspace.view.camera.orbit(0.5f, 0);
  cast(SliceLayer::classified).restsAt = ImGui::GetTime() + 10;  // as after a turn of the wheel in it
  frame();
  frame();
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_TRUE((*views.casts)[n].state.moving) << n;
    EXPECT_NE((*views.casts)[n].drawn, before[n]) << n;
  }
  EXPECT_TRUE(views.space.state.moving);
  cast(SliceLayer::classified).restsAt = 0;
  EXPECT_TRUE(settle());
  for (std::size_t n = 0; n < 3; ++n) EXPECT_FALSE((*views.casts)[n].state.moving) << "none holds another";
}

TEST_F(Casts, GiveTheirMemoryBack) {
  ASSERT_TRUE(settle());
  EXPECT_EQ(views.casts, nullptr);
  command("layout.casts").run(workspace);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(views.scans.raw.empty());
  EXPECT_FALSE(views.scans.thinned.empty());
  workspace.view.surfaceVoxels = false;
  command("layout.fourUp").run(workspace);
  ASSERT_TRUE(settle());
  EXPECT_EQ(views.casts, nullptr);
  EXPECT_TRUE(views.scans.thinned.empty()) << "no slice shows it";
}

}  // namespace
}  // namespace sonoskin::ui
