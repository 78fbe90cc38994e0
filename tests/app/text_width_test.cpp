// Whether every text of the window fits its place, in all languages at 1280x720: nothing is cut off, nothing lies over its
// neighbour.
#include <gtest/gtest.h>

#include "app/panels/command_palette.h"
#include "app/panels/export_dialog.h"
#include "app/panels/panels.h"
#include "app/panels/sheet_window.h"
#include "app/panels/tour.h"
#include "app/texts/texts.h"
#include "app/widgets/file_dialog.h"
#include "app/workspace/commands.h"
#include "app/workspace/help_state.h"
#include "app/workspace/palette_entries.h"
#include "app/workspace/tour.h"
#include "core/pipeline/presets.h"
#include "core/skin/skin_presets.h"
#include "tests/app/session_support.h"
#include "tests/support/drawn_texts.h"
#include "tests/support/imgui_test.h"

namespace sonoskin::ui {
namespace {

class TextWidth : public ImGuiTest, public testing::WithParamInterface<Language> {
 protected:
  explicit TextWidth(const ImVec2& size = {1280, 720}) : ImGuiTest(size), size_(size) {
    useLanguage(GetParam());
  }
  ~TextWidth() override { useLanguage(Language::english); }

  void SetUp() override {
    ImGuiTest::SetUp();
    for (int key = 0; key < ImGuiKey_COUNT; ++key) ImGui::GetIO().KeyMap[key] = key;  // menus ask for keys
  }
  // draw: what a frame has.
  virtual void draw() = 0;

  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      rects.byName.clear();
      ImGui::NewFrame();
      draw();
      ImGui::Render();
    }
  }
  // expectFit: after some frames, in which windows find their sizes.
  void expectFit(const std::string& what) {
    frames(4);
    SCOPED_TRACE(what);
    for (const std::string& fault : textFaults()) ADD_FAILURE() << fault;
    for (const auto& [name, rect] : rects.byName) EXPECT_FALSE(name.starts_with("cut.")) << name;
  }
  void click(const std::string& name) {
    const auto& [min, max] = rects.byName.at(name);
    ImGui::GetIO().MousePos = {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)};
    frames(2);
    for (const bool down : {true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      frames(2);
    }
    ImGui::GetIO().MousePos = {-1000, -1000};
  }
  void makeSurface() {
    workspace.session.openPhantom();
    ASSERT_TRUE(test::wait(workspace.session));
    workspace.session.reconstruct();
    ASSERT_TRUE(test::wait(workspace.session));
    workspace.session.poll();
    ASSERT_TRUE(workspace.session.results().mesh);
  }

  Workspace workspace{test::tinySurface()};
  const ImVec2 size_;
};

// The side panel, so high that nothing of it is scrolled away.
class SidePanelWidth : public TextWidth {
 protected:
  SidePanelWidth() : TextWidth({1280, 3200}) {}
  void draw() override {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(size_);
    ImGui::Begin("main", nullptr, ImGuiWindowFlags_NoDecoration);
    drawSidePanel(workspace, {sidePanelWidth(), 3200});
    ImGui::End();
  }
  void openFoldouts() {
    frames(2);
    std::vector<std::string> names;
    for (const auto& [name, rect] : rects.byName)
      if (name.starts_with("foldout.")) names.push_back(name);
    for (const std::string& name : names) click(name);
  }
};

TEST_P(SidePanelWidth, HasRoomForEachStep) {
  for (const Step step : kSteps) {
    workspace.step = step;
    expectFit(std::string("without a scan: ") + stepName(step));
  }
  makeSurface();
  workspace.view.content = SpaceContent::mesh;
  workspace.view.meshStyle = MeshStyle::skin;
  for (const Step step : kSteps) {
    workspace.step = step;
    openFoldouts();
    expectFit(stepName(step));
  }
}

// The n-th of each parameter that is chosen from a list, or the last one.
Parameters withChoice(std::size_t n, bool& any) {
  Parameters parameters;
  forEachField(
      [&](const Group&, const Field&, auto& value, auto...) {
        if constexpr (NamedEnum<std::decay_t<decltype(value)>>) {
          const std::size_t count = enumNames(value).size();
          any = any || n < count;
          value = std::decay_t<decltype(value)>(std::min(n, count - 1));
        }
      },
      parameters);
  return parameters;
}

TEST_P(SidePanelWidth, HasRoomForEachChoice) {
  bool any = true;
  for (std::size_t n = 0; std::exchange(any, false); ++n) {
    workspace.session.edit(withChoice(n, any));
    for (const Step step : kSteps) {
      workspace.step = step;
      openFoldouts();
      expectFit(fmt::format("choice {} of {}", n, stepName(step)));
    }
  }
}

// Presets are choices, too.
TEST_P(SidePanelWidth, HasRoomForEachPreset) {
  for (const Preset& preset : presets()) {
    Parameters parameters;
    applyPreset(preset, parameters);
    workspace.session.edit(parameters);
    workspace.step = Step::classify;
    expectFit(std::string(preset.name));
  }
  for (const SkinPreset& preset : skinPresets()) {
    Parameters parameters;
    applySkinPreset(preset, parameters.skin, parameters.light);
    workspace.session.edit(parameters);
    workspace.step = Step::skin;
    expectFit(std::string(preset.name));
  }
}

// All that lies around the views, and over them.
class WindowWidth : public TextWidth {
 protected:
  void draw() override {
    drawMenuBar(workspace);
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->WorkPos);
    ImGui::SetNextWindowSize(ImGui::GetMainViewport()->WorkSize);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::Begin("main", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    drawViewBars(workspace, panes);
    ImGui::SetCursorPos({12, ImGui::GetMainViewport()->WorkSize.y - 28});
    drawStatusBar(workspace);
    ImGui::End();
    drawKeys(workspace);
    drawAbout(workspace);
    drawHistory(workspace);
    drawPalette(workspace);
    drawQuestion(workspace);
    drawPictureQuestion(workspace);
    drawColoursWindow(workspace);
    drawVolumeChoice(workspace);
    drawRawQuestion(workspace);
    drawDropped(workspace);
    drawRecovery(workspace);
    drawLog(workspace);
    sheet.draw(workspace, {});
    exports.draw(workspace);
    tour.draw(workspace);
    drawFileDialog(workspace.files);
  }
  // expectFitOnce: while something is shown, which goes again.
  void expectFitOnce(const std::string& what) {
    expectFit(what);
    workspace.dropQuestions();
    while (hasHelpWindow(workspace)) closeHelpWindow(workspace);
    ImGui::ClosePopupsOverWindow(nullptr, false);
    frames(2);
  }

  std::vector<ShownPane> panes;
  TourWindow tour;
  SheetWindow sheet;
  ExportDialog exports;
};

TEST_P(WindowWidth, HasRoomForMenus) {
  for (std::size_t menu = 0; menu < kMenuTitles.size(); ++menu) {
    workspace.menuAsked = Menu(menu);
    frames(4);
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      const bool isMenu = window->Active && (window->Flags & ImGuiWindowFlags_ChildMenu);
      EXPECT_EQ(isMenu ? window->ScrollMax.y : 0, 0) << kMenuTitles[menu] << " is higher than the window";
    }
    expectFitOnce(kMenuTitles[menu]);
  }
}

TEST_P(WindowWidth, HasRoomForHelp) {
  workspace.keysShown = true;
  expectFitOnce("keys");
  workspace.aboutShown = true;
  expectFitOnce("about");
  for (const Command& c : commands()) {
    openPalette(workspace);
    workspace.help.words = commandTitle(c);
    expectFitOnce(std::string("palette: ") + c.id);
  }
  workspace.help.offered = true;
  expectFitOnce("offer");
  for (std::size_t card = 0; card < tourCards().size(); ++card) {
    workspace.help.tour = card;
    expectFitOnce(fmt::format("card {}", card));
  }
  workspace.toasts.add("An error", true);
  workspace.toasts.log.open();
  expectFitOnce("messages");
}

TEST_P(WindowWidth, HasRoomForQuestions) {
  for (const char* what : {"Quitting", "Opening another scan", "Setting all parameters back"}) {
    workspace.question = {tr(what), [] {}};
    expectFitOnce(what);
  }
  workspace.rawQuestion = Workspace::RawQuestion{"scan.raw", {}, 1000000};
  expectFitOnce("raw");
  workspace.dropped = {"a.nrrd", "b.nrrd"};
  expectFitOnce("dropped");
  workspace.recovery = Workspace::Recovery{"2026-11-28 12:34, NRRD", [] {}, [] {}};
  expectFitOnce("recovery");
  for (const bool turntable : {false, true}) {
    workspace.pictureRequest = PictureRequest{turntable};
    expectFitOnce("picture");
  }
  for (int purpose = 0; purpose <= int(FilePurpose::saveReport); ++purpose) {
    workspace.files.ask(FilePurpose(purpose), "/", "");
    workspace.files.complaint = tr("There is no file of that name here; choose one of the list.");
    workspace.files.replaceAsked = purpose % 2 == 0;
    expectFitOnce(purposeText(FilePurpose(purpose)).title);
    workspace.files.purpose.reset();
    ImGui::ClosePopupsOverWindow(nullptr, false);
    frames(2);
  }
}

TEST_P(WindowWidth, HasRoomForWhatIsExported) {
  makeSurface();
  workspace.exportShown = true;
  frames(3);
  for (const ExportItem& item : exportItems()) {
    click(std::string("export.") + item.id);
    expectFit(item.id);
  }
  workspace.exportShown = false;
  workspace.sheetShown = true;
  expectFitOnce("contact sheet");
}

// What a narrow line has no room for is left out.
TEST_P(WindowWidth, HasRoomForTheStatus) {
  makeSurface();
  for (const float width : {500.f, 700.f, 900.f, 1100.f}) {
    ImGui::GetIO().DisplaySize.x = width;
    expectFit(fmt::format("{} wide", width));
  }
}

// The bars over the views of four equal parts, and what lies behind their dots.
TEST_P(WindowWidth, HasRoomForBars) {
  makeSurface();
  const glm::vec2 first(376, 22), half(450, 330);
  for (int n = 0; n < 4; ++n)
    panes.push_back({Pane(n), first + half * glm::vec2(n % 2, n / 2), half - 4.0f, false});
  const auto openAndFit = [this](const std::string& name) {
    expectFit(name);
    for (const char* more : {"view.space.more", "view.slice.more"}) {
      click(more);
      expectFit(name + more);
      ImGui::ClosePopupsOverWindow(nullptr, false);
      frames(2);
    }
  };
  for (const VolumeStyle style : {VolumeStyle::surface, VolumeStyle::translucent, VolumeStyle::maximum}) {
    workspace.view.volumeStyle = style;
    workspace.view.clip.on = true;
    openAndFit("volume ");
  }
  workspace.view.content = SpaceContent::mesh;
  openAndFit("mesh ");
  workspace.view.content = SpaceContent::volume;
  workspace.view.volumeStyle = VolumeStyle::translucent;
  workspace.view.volume.edited = true;
  expectFit("colours");
}

const auto kLanguages = testing::Values(Language::english, Language::german, Language::french);
std::string nameOf(const testing::TestParamInfo<Language>& info) {
  return std::array{"English", "German", "French"}[std::size_t(info.param)];
}
INSTANTIATE_TEST_SUITE_P(In, SidePanelWidth, kLanguages, nameOf);
INSTANTIATE_TEST_SUITE_P(In, WindowWidth, kLanguages, nameOf);

}  // namespace
}  // namespace sonoskin::ui
