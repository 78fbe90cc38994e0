// The texts in the views, at 1280x720 in each language: nothing is cut off, nothing lies over its neighbour.
#include "tests/app/window/window_driver.h"
#include "tests/support/drawn_texts.h"

namespace sonoskin {
namespace {

class TextWindow : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    driver.reset();
    Settings settings;
    settings.width = 1280;
    settings.height = 720;
    settings.tourOffered = true;
    writeSettings(settingsFile(), settings);
    driver = std::make_unique<Driver>(smallPhantom());
  }
  void expectFit(const std::string& what) {
    driver->frames(6);
    for (const std::string& fault : ui::textFaults()) ADD_FAILURE() << what << ": " << fault;
  }
  void expectViewsFit(const std::string& language) {
    Workspace& w = driver->workspace();
    w.settings.layout.layout = Layout::fourUp;
    w.view.parts = false;
    w.view.content = SpaceContent::volume;
    expectFit(language + " volume");
    for (const Layout layout : {Layout::compare, Layout::casts, Layout::oblique}) {
      w.settings.layout.layout = layout;
      expectFit(language + " " + enumNames(layout)[std::size_t(layout)]);
    }
    w.settings.layout.layout = Layout::fourUp;
    w.view.content = SpaceContent::mesh;
    expectFit(language + " mesh");
    w.view.parts = true;
    expectFit(language + " parts");
    w.view.parts = false;
    w.view.meshStyle = MeshStyle::skin;
    w.view.skin.reach = w.view.skin.places = w.view.skin.lamp = true;
    w.step = Step::skin;
    for (const SkinCompare compare : {SkinCompare::scatter, SkinCompare::settings}) {
      w.view.skin.compare = compare;
      expectFit(language + " skin");
    }
    w.view.skin.compare = SkinCompare::off;
    for (bool* shown : {&w.sheetShown, &w.exportShown}) {
      *shown = true;
      expectFit(language + (shown == &w.exportShown ? " export" : " contact sheet"));
      *shown = false;
    }
  }
};

TEST_F(TextWindow, HasRoomInTheViews) {
  ASSERT_TRUE(driver->waitUntilIdle());
  driver->press("ctrl+Return");
  ASSERT_TRUE(driver->waitUntilIdle());
  ASSERT_TRUE(driver->session().results().mesh);
  const std::array names{"English", "German", "French"};
  for (std::size_t n = 0; n < names.size(); ++n) {
    driver->workspace().settings.language = LanguageChoice(1 + n);
    expectViewsFit(names[n]);
  }
}

}  // namespace
}  // namespace sonoskin
