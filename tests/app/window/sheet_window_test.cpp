// The contact sheet of the window: made in the background, a click on a picture takes its values, and it is saved.
#include <cmath>

#include "render/gl/context.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

class SheetWindowTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(driver->waitUntilIdle());
    driver->workspace().sheetShown = true;
    driver->frames(3);
  }
  void TearDown() override { EXPECT_EQ(gl::glErrorCount(), 0) << gl::lastGlError(); }
};

TEST_F(SheetWindowTest, AClickOnAPictureTakesItsValuesAndUndoBringsTheOldOnesBack) {
  Driver& d = *driver;
  const auto& parameters = [&]() -> const ClassificationOptions& {
    return d.session().parameters().classification;
  };
  const double before = parameters().beta;
  d.click("sheet.make");
  ASSERT_TRUE(d.wait([&] { return d.knows("sheet.cell.24"); }));
  EXPECT_FALSE(d.knows("sheet.cell.25")) << "five by five";
  d.frames(3);
  d.click("sheet.cell.3");
  EXPECT_NEAR(parameters().beta, 1.25 * before, 1e-9);
  EXPECT_GT(parameters().isoValue, 0);
  d.session().undo();
  EXPECT_EQ(parameters().beta, before);
  EXPECT_EQ(parameters().isoValue, 0);

  d.workspace().files.ask(ui::FilePurpose::saveSheet, folder.path(), "sheet.png");
  d.frames(4);
  d.press("Return");
  ASSERT_TRUE(d.wait([&] { return fs::exists(folder / "sheet.recipe.json") && !d.session().saving(); }));
  EXPECT_GT(readPng(folder / "sheet.png").width, 5 * 320);
}

TEST_F(SheetWindowTest, WhatIsMadeCanBeCancelledAndEscapeClosesTheDialog) {
  Driver& d = *driver;
  d.click("sheet.make");
  ASSERT_TRUE(d.wait([&] { return d.knows("sheet.cancel"); }));
  d.click("sheet.cancel");
  d.frames(20);
  EXPECT_FALSE(d.knows("sheet.cell.0"));
  d.press("Escape");
  EXPECT_FALSE(d.workspace().sheetShown);
}

}  // namespace
}  // namespace sonoskin
