// The export dialog by mouse and keys: what is there already is asked about, and nothing gets another name.
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

class ExportWindowTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(driver->waitUntilIdle());
    driver->workspace().settings.folder = folder.path();
    driver->press("ctrl+e");
    ASSERT_TRUE(driver->workspace().exportShown);
    driver->frames(3);
  }
};

TEST_F(ExportWindowTest, AsksBeforeAnythingIsReplaced) {
  Driver& d = *driver;
  folder.write("points.ply", "somebody's");
  d.click("export.points");
  d.click("export.accept");
  EXPECT_TRUE(d.workspace().exportShown) << "it asks";
  EXPECT_EQ(test::fileText(folder / "points.ply"), "somebody's");
  d.click("export.accept");
  EXPECT_FALSE(d.workspace().exportShown);
  ASSERT_TRUE(d.wait(
      [&] { return !d.session().saving() && test::fileText(folder / "points.ply").starts_with("ply"); }));
}

TEST_F(ExportWindowTest, ANameWithAnotherEndingIsNotWritten) {
  Driver& d = *driver;
  d.click("export.scan");
  d.click("export.name");
  d.press("ctrl+a");
  d.mouse("type face.xyz");
  d.click("export.accept");
  EXPECT_TRUE(d.workspace().exportShown);
  EXPECT_TRUE(fs::is_empty(folder.path()) || !fs::exists(folder / "face.xyz.nrrd"));
  d.press("Escape");
  EXPECT_FALSE(d.workspace().exportShown);
}

// The report of the window has the measures, with their marks in millimetres.
TEST_F(ExportWindowTest, TheReportHasTheMeasures) {
  Driver& d = *driver;
  d.session().reconstruct();
  ASSERT_TRUE(d.wait([&] { return d.session().reconstructions() > 0; }));
  ASSERT_TRUE(d.waitUntilIdle());
  d.workspace().view.measures = {{MeasureKind::distance, {{1, 2, 3}, {4, 6, 15}}}};
  d.click("export.report");
  d.click("export.accept");
  ASSERT_TRUE(d.wait([&] { return fs::exists(folder / "report.json") && !d.session().saving(); }));
  const std::string report = test::fileText(folder / "report.json");
  EXPECT_NE(report.find("\"marks_mm\""), std::string::npos) << report;
  EXPECT_NE(report.find("\"value\": 13.0"), std::string::npos) << report;
}

}  // namespace
}  // namespace sonoskin
