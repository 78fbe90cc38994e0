// What the window asks before it opens a file: what one without a header holds, and which of several volumes it is.
#include "tests/app/window/window_driver.h"
#include "tests/support/kretz.h"

namespace sonoskin {
namespace {

// Numbers that rise along the first axis.
std::string numbers(int count) {
  std::string bytes;
  for (int n = 0; n < count; ++n) bytes += char(n % 251);
  return bytes;
}

TEST_F(WindowTest, AsksWhatAFileWithoutAHeaderHolds) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  d.workspace().open(folder.write("scan.raw", numbers(20 * 30 * 40)));
  d.frames(4);
  ASSERT_TRUE(d.workspace().rawQuestion);
  d.workspace().rawQuestion->options.dims = {20, 30, 41};
  d.frames(3);
  d.click("raw.open");
  EXPECT_TRUE(d.workspace().rawQuestion) << "it has not that many numbers";
  d.workspace().rawQuestion->options.dims = {20, 30, 40};
  d.workspace().rawQuestion->options.spacing = {0.5, 0.5, 0.75};
  d.frames(3);
  d.click("raw.open");
  EXPECT_FALSE(d.workspace().rawQuestion);
  ASSERT_TRUE(d.wait([&] { return d.session().scan().volume->geometry.dims == glm::ivec3(20, 30, 40); }));
  EXPECT_EQ(d.session().scan().volume->geometry.spacing, glm::dvec3(0.5, 0.5, 0.75));
  EXPECT_NEAR(d.session().scan().volume->at(19, 0, 0), 19 / 255.0, 1e-6);

  // A name that promises another format: what was said of the file before is not taken for this one.
  d.workspace().open(folder.write("other.vol", numbers(20 * 30 * 40)));
  ASSERT_TRUE(d.waitUntilIdle());
  d.frames(3);
  EXPECT_EQ(d.session().name(), "scan.raw");
  EXPECT_FALSE(isTold(d.session().parameters().raw));
}

// Other programs, and whoever sees a shared screen, read titles.
TEST_F(WindowTest, TheTitleHoldsNoNameOfAFile) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  const fs::path file = folder.write("Featherstone.nrrd",
                                     "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 20 30 40\n"
                                     "spacings: 1 1 1\nencoding: raw\n\n" +
                                         numbers(24000));
  d.workspace().open(file);
  ASSERT_TRUE(d.wait([&] { return d.session().name() == "Featherstone.nrrd"; }));
  d.frames(5);
  EXPECT_EQ(std::system("xdotool search --name Sonoskin > /dev/null"), 0);
  EXPECT_NE(std::system("xdotool search --name Featherstone > /dev/null"), 0);
}

TEST_F(WindowTest, AsksWhichOfSeveralVolumesIsOpened) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  test::KretzWriter kretz;
  kretz.dims(24, 24, 24).values(0xC100, 1, {0.001}).record(0xD000, 1, numbers(24 * 24 * 24));
  kretz.dims(24, 24, 24, 1).values(0xC100, 0x101, {0.002}).record(0xD000, 0x101, numbers(24 * 24 * 24)).end();
  d.workspace().open(folder.write("two.vol", kretz.bytes()));
  ASSERT_TRUE(d.wait([&] { return d.workspace().choice.has_value(); }));
  d.frames(4);
  d.press("Escape");
  EXPECT_FALSE(d.workspace().choice);
  EXPECT_EQ(d.session().name(), "Phantom");
  d.workspace().open(folder / "two.vol");
  ASSERT_TRUE(d.wait([&] { return d.workspace().choice.has_value(); }));
  d.frames(4);
  d.click("choice.2");
  ASSERT_TRUE(d.wait([&] { return d.session().name() == "two.vol"; }));
  EXPECT_NEAR(d.session().scan().volume->geometry.spacing.x, 2, 1e-9);
}

}  // namespace
}  // namespace sonoskin
