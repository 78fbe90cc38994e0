// Every value of every choice that a person has, in pairs, and every number at both ends of its range: the window's whole
// frame is drawn with each, and nothing of it throws.
#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>
#include <limits>

#include "app/panels/panels.h"
#include "app/views/four_up.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/check_ranges.h"
#include "render/gl/context.h"
#include "tests/app/session_support.h"
#include "tests/support/imgui_test.h"
#include "tests/support/legal_values.h"
#include "tests/support/temp_folder.h"

namespace sonoskin::ui {
namespace {

bool isFinite(const glm::mat4& m) {
  bool finite = true;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) finite = finite && std::isfinite(m[column][row]);
  return finite;
}

class LegalSettings : public ImGuiTest {
 protected:
  LegalSettings() : ImGuiTest({640, 420}), workspace(test::tinyPhantom()) {}

  void SetUp() override {
    ImGuiTest::SetUp();
    context_->makeCurrent();
    workspace.settings.skinQuality = SkinQualityChoice::light;
    // Of a file, which does not tell where the probe was: the sides count then.
    const std::filesystem::path file = folder_ / "scan.nrrd";
    writeVolume(file, *makePhantomScan(test::tinyPhantom().phantom).volume);
    workspace.session.openFile(file);
    ASSERT_TRUE(test::wait(workspace.session));
    workspace.session.followParameters(false);  // the mesh stays: it is pictures that are tested
    workspace.session.reconstruct();
    ASSERT_TRUE(test::wait(workspace.session));
    ASSERT_TRUE(workspace.session.results().mesh);
    resetView(workspace.view, workspace.session.scan(), workspace.session.beam());
    showSkin();
  }
  // Frames until the skin is prepared.
  void showSkin() {
    workspace.view.content = SpaceContent::mesh;
    const Timer timer;
    while (!views_.space.skin.shows(workspace) && timer.seconds() < 60) frame();
    ASSERT_TRUE(views_.space.skin.shows(workspace));
  }

  void frame() {
    rects.byName.clear();
    workspace.session.poll();
    workspace.session.takeMessages();
    beginFrame();
    ImGui::BeginChild("side", {300, 0});
    drawStepList(workspace);
    drawWork(workspace);
    drawVolumePanel(workspace);
    drawRegionPanel(workspace);
    drawClassificationPanel(workspace);
    drawReconstructionPanel(workspace);
    drawSkinPanel(workspace);
    drawExportPanel(workspace);
    drawStatusBar(workspace);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("views");
    drawFourUp(views_, workspace);
    drawViewBars(workspace, views_.shown);
    ImGui::EndChild();
    ImGui::End();
    ImGui::Render();
  }

  // A frame with parameters that somebody set, and from the place where one looks at the start.
  void expectFrame(const Parameters& parameters, const std::string& what) {
    ASSERT_NO_THROW({
      workspace.session.edit(parameters);
      workspace.lookAtFace();
      frame();
      workspace.session.commitEdit();
    }) << what;
    EXPECT_EQ(gl::glErrorCount(), errors_) << what << ": " << gl::lastGlError();
    const Camera& camera = workspace.view.camera;
    EXPECT_TRUE(isFinite(camera.projection(1, {glm::vec3(-50), glm::vec3(50)}) * camera.view())) << what;
    EXPECT_NEAR(glm::length(camera.right()), 1, 1e-4) << what;
    const Beam beam = workspace.session.beam();
    EXPECT_NEAR(glm::length(glm::cross(beam.axis, beam.up)), 1, 1e-6) << what;
  }

  // The choices of the view, which are no parameters.
  void addViewChoices(std::vector<test::Choice>& choices) {
    ViewState& v = workspace.view;
    const auto add = [&](const char* name, int count, std::function<void(int)> choose) {
      choices.push_back({name, count, std::move(choose)});
    };
    add("content", 2, [&v](int i) { v.content = SpaceContent(i); });
    add("volumeStyle", 2, [&v](int i) { v.volumeStyle = VolumeStyle(i); });
    add("volumeLayer", 2, [&v](int i) { v.volumeLayer = VolumeLayer(i); });
    add("meshStyle", 2, [&v](int i) { v.meshStyle = MeshStyle(i); });
    add("layer", 3, [&v](int i) { v.layer = SliceLayer(i); });
    add("pass", int(enumNames(SkinPass{}).size()), [&v](int i) { v.skin.pass = SkinPass(i); });
    add("compare", 3, [this, &v](int i) {
      v.skin.compare = SkinCompare(i);
      const Parameters& p = workspace.session.parameters();
      v.skin.kept = SkinSettings{p.skin, p.light, p.landmarks};
    });
    for (bool* flag : {&v.surfaceVoxels, &v.cropBox, &v.crop, &v.unmeasured, &v.parts, &v.skin.lamp,
                       &v.skin.reach, &v.skin.places, &v.toolHeld})
      add("flag", 2, [flag](int i) { *flag = i == 1; });
    add("sliceTool", int(kTools.size()), [&v](int i) { v.sliceTool = Tool(i); });
    add("spaceTool", int(kTools.size()), [&v](int i) { v.spaceTool = Tool(i); });
    add("maximised", 5, [&v](int i) { v.maximised = i < 4 ? std::optional(Pane(i)) : std::nullopt; });
  }

  Workspace workspace;

 private:
  test::TempFolder folder_;
  std::unique_ptr<gl::Context> context_ = gl::makeOffscreenContext(gl::Backend::egl);
  FourUp views_;
  int errors_ = gl::glErrorCount();
};

TEST_F(LegalSettings, InPairs) {
  Parameters parameters = workspace.session.parameters();
  std::vector<test::Choice> choices =
      test::choicesOf(parameters, [](const std::string& group) { return group != "phantom"; });
  addViewChoices(choices);
  test::chooseInPairs(choices, [&](const std::string& chosen) { expectFrame(parameters, chosen); });
}

TEST_F(LegalSettings, AtTheEndsOfAllRanges) {
  for (const SpaceContent content : {SpaceContent::mesh, SpaceContent::volume}) {
    workspace.view.content = content;
    test::forEachEnd(workspace.session.parameters(),
                     [&](const std::string& name, const Parameters& p) { expectFrame(p, name); });
  }
}

// What a window is started with, or a recipe holds, is not edited, and is drawn all the same.
TEST(LegalStart, ProbeAndTopOnOneAxisMakeRoom) {
  for (int probe = 0; probe < 6; ++probe)
    for (int top = 0; top < 6; ++top) {
      Parameters given = test::tinyPhantom();
      given.scan.probeSide = VolumeSide(probe);
      given.scan.topSide = VolumeSide(top);
      const Session session(given);
      const ScanOptions& scan = session.parameters().scan;
      EXPECT_NE(int(scan.probeSide) / 2, int(scan.topSide) / 2) << probe << " " << top;
      if (probe / 2 != top / 2) {
        EXPECT_EQ(scan.probeSide, given.scan.probeSide);
        EXPECT_EQ(scan.topSide, given.scan.topSide);
      }
    }
}

// Whatever an editor brings, a session's numbers are within their ranges: its recipe can be read again.
TEST(LegalStart, NumbersOutsideTheirRangesAreBroughtInto) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {-1e300, 1e300, nan}) {
    Session session(test::tinyPhantom());
    Parameters p = session.parameters();
    forEachField(
        [&](const Group&, const Field&, auto& member, const auto&... range) {
          using T = std::remove_reference_t<decltype(member)>;
          if constexpr (std::is_same_v<T, double> && sizeof...(range) > 0) member = wrong;
          if constexpr (std::is_same_v<T, std::array<double, 3>>) member.fill(wrong);
          if constexpr (std::is_same_v<T, int>) member = wrong > 0 ? 2'000'000'000 : -2'000'000'000;
        },
        p);
    p.mesh.partsCut = {{wrong, 0, 0}, {0, wrong, 0}, {0, 0, 0}, {1, 2, 3}};
    session.edit(p);
    EXPECT_NO_THROW(checkRanges(session.parameters())) << wrong;
    EXPECT_EQ(session.parameters().mesh.partsCut.size(), 3u);
  }
}

}  // namespace
}  // namespace sonoskin::ui
