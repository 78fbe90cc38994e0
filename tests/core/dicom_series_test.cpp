// Which slices of DICOM make a volume, and where they lie.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "core/io/dicom/dicom_series.h"
#include "core/io/volume_loader.h"
#include "core/io/volume_reader.h"
#include "tests/support/dicom_series.h"
#include "tests/support/expect_error.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::asIs;
using test::DicomImage;
using test::expectError;
using test::expectRamp;
using test::kColumns;
using test::kRows;
using test::place;
using test::ramp;
using test::SeriesFolder;
using test::warned;

TEST(DicomSeries, LiesWhereItsSlicesDo) {
  const SeriesFolder folder;
  folder.series(6, [](DicomImage& image, int k) {
    image.position = place({-3, 5 - 2.0 * k, 7});
    image.orientation = "1\\0\\0\\0\\0\\-1";  // the normal is y, so that the last file comes first
  });
  const LogRecord record;
  const Geometry g = loadVolume(folder.path()).stored.geometry;
  EXPECT_EQ(g.dims, glm::ivec3(kColumns, kRows, 6));
  EXPECT_NEAR(glm::length(g.origin - glm::dvec3(-3, -5, 7)), 0, 1e-9);
  EXPECT_NEAR(glm::length(g.toWorld({2, 4, 5}) - glm::dvec3(-2, 5, 5)), 0, 1e-9);
  EXPECT_TRUE(record.sentences(LogLevel::warning).empty());
}

TEST(DicomSeries, OfATiltedGantryIsPutOntoAStraightGrid) {
  for (const glm::dvec2 shift : {glm::dvec2(0, 0.232), glm::dvec2(-0.31, 0), glm::dvec2(0.4, -0.15)}) {
    const SeriesFolder folder;
    folder.series(40, [&](DicomImage& image, int k) {
      image = ramp(k + 1, {1 + shift.x * k, 2 + shift.y * k, 1.5 * k});
    });
    const LogRecord record;
    const LoadedVolume v = loadVolume(folder.path());
    EXPECT_TRUE(warned(record, "straight grid"));
    EXPECT_NEAR(v.stored.geometry.spacing.z, 1.5, 1e-9);
    EXPECT_NEAR(glm::length(v.stored.geometry.direction[2] - glm::dvec3(0, 0, 1)), 0, 1e-12);
    // Of 120 pixels of each slice, those at two borders lie between the grid's points.
    EXPECT_GE(expectRamp(v), 40 * (kColumns - 1) * (kRows - 1));
    EXPECT_EQ(readScan(folder.path()).volume->geometry.dims, v.stored.geometry.dims);
    EXPECT_EQ(v.stored.geometry.dims.z, 40);
  }
}

// What decimals of a header can make is none.
TEST(DicomSeries, RoundedPlacesAreStraight) {
  const SeriesFolder folder;
  folder.series(30, [](DicomImage& image, int k) {
    image.position = place({0.0004 * (k % 3), -0.0003 * (k % 2), std::round(6.25 * k) / 10});
  });
  const LogRecord record;
  const LoadedVolume v = loadVolume(folder.path());
  EXPECT_EQ(v.stored.geometry.dims, glm::ivec3(kColumns, kRows, 30));
  EXPECT_EQ(v.stored.type, NumberType::uint16);
  EXPECT_TRUE(record.sentences(LogLevel::warning).empty());
}

TEST(DicomSeries, ThatTurnsIsRefusedForThat) {
  for (const double degrees : {1.5, 0.3, -5.0, 20.0}) {
    const SeriesFolder folder;
    folder.series(12, [&](DicomImage& image, int k) {
      const double a = degrees * k * std::numbers::pi / 180;
      image.orientation = fmt::format("1\\0\\0\\0\\{:.8f}\\{:.8f}", std::cos(a), std::sin(a));
    });
    expectError([&] { readScan(folder.path()); },
                fmt::format("turn against each other, by {:.1f} degrees", std::abs(degrees)).c_str());
    expectError([&] { readScan(folder / "s03.dcm"); }, "turn against each other");
  }
}

TEST(DicomSeries, ThatMissesSlicesSaysHowMany) {
  const SeriesFolder folder;
  folder.series(12, [](DicomImage& image, int k) {
    image.position = place({0, 0, 2.0 * (k + (k > 4) + (k > 7))});
  });
  expectError([&] { readScan(folder.path()); }, "2 are missing, the first one after slice 5 of 12");
}

TEST(DicomSeries, OfUnevenDistancesSaysSo) {
  const SeriesFolder folder, growing;
  folder.series(9, [](DicomImage& image, int k) {
    image.position = place({0, 0, k < 5 ? 2.0 * k : 3.0 * k - 5});
  });
  expectError([&] { readScan(folder.path()); }, "not evenly spaced: 2 to 3 mm");
  // Less than a tenth from one to the next, and several slices in all.
  growing.series(60, [](DicomImage& image, int k) {
    image.position = place({0, 0, 2.0 * k + 0.003 * k * k});
  });
  expectError([&] { readScan(growing.path()); }, "not evenly spaced");
}

TEST(DicomSeries, ThatIsShiftedUnevenlySaysSo) {
  const SeriesFolder folder;
  folder.series(9, [](DicomImage& image, int k) { image.position = place({k == 4 ? 3.0 : 0, 0, 2.0 * k}); });
  expectError([&] { readScan(folder.path()); }, "shifted against each other");
}

TEST(DicomSeries, WithoutPlacesSaysSo) {
  const SeriesFolder folder;
  folder.series(9, [](DicomImage& image, int) { image.position = ""; });
  expectError([&] { readScan(folder.path()); }, "do not say where they lie");
  const SeriesFolder some;
  some.series(9, [](DicomImage& image, int k) {
    if (k > 6) image.position = "";
  });
  const LogRecord record;
  EXPECT_EQ(loadVolume(some.path()).stored.geometry.dims.z, 7);
  EXPECT_TRUE(warned(record, "2 of the series' 9 slices are left out"));
}

TEST(DicomSeries, AFileWithoutAPlaceIsNoPartOfItsSeries) {
  const SeriesFolder folder;
  folder.series(9, [](DicomImage& image, int k) {
    if (k == 3) image.position = "";
  });
  expectError([&] { readScan(folder / "s03.dcm"); }, "does not say where it lies");
}

TEST(DicomSeries, WithSlicesTwiceSaysSo) {
  const SeriesFolder folder;
  folder.series(6, asIs);
  folder.series(
      6, [](DicomImage& image, int) { image.number += 100; }, "t");
  expectError([&] { readScan(folder.path()); }, "2 slices at the same place, at 6 of its 6 places");
}

// The same instance under another name is a copy.
TEST(DicomSeries, CopiesOfFilesAreLeftOut) {
  const SeriesFolder folder;
  folder.series(6, asIs);
  folder.series(2, asIs, "copy");
  const LogRecord record;
  EXPECT_EQ(expectRamp(loadVolume(folder.path())), 6 * kColumns * kRows);
  EXPECT_TRUE(warned(record, "2 files are left out as copies"));
}

// Some programs give all slices the same UID.
TEST(DicomSeries, SlicesOfOneUidAreNoCopies) {
  const SeriesFolder folder, timed, unplaced;
  const auto sameUid = [](DicomImage& image, int) { image.instance = "1.2.3"; };
  folder.series(6, [&](DicomImage& image, int k) { sameUid(image, k), image.number = 1; });
  folder.series(
      2, [&](DicomImage& image, int k) { sameUid(image, k), image.number = 1; }, "copy");
  const LogRecord record;
  EXPECT_EQ(expectRamp(loadVolume(folder.path())), 6 * kColumns * kRows);
  EXPECT_EQ(expectRamp(loadVolume(folder / "s03.dcm")), 6 * kColumns * kRows);
  EXPECT_TRUE(warned(record, "2 files are left out as copies"));
  unplaced.series(6, [&](DicomImage& image, int k) { sameUid(image, k), image.position = ""; });
  expectError([&] { readScan(unplaced.path()); }, "The 6 slices in");
  for (const char* time : {"120000", "120003"})
    timed.series(
        6,
        [&](DicomImage& image, int k) {
          sameUid(image, k), image.others.push_back({8, 0x32, "TM", time});
        },
        time);
  EXPECT_EQ(loadVolume(timed.path()).stored.timeSteps, 2);
}

TEST(DicomSeries, TellsOfTwoDistances) {
  const SeriesFolder folder;
  folder.series(6, [](DicomImage& image, int) { image.others.push_back({0x18, 0x88, "DS", "1.5"}); });
  const LogRecord record;
  EXPECT_EQ(loadVolume(folder.path()).stored.geometry.spacing.z, 2);
  EXPECT_TRUE(warned(record, "2 mm apart by their places, which are used, and 1.5 mm"));
}

// One damaged file of a folder is no reason to trust or to refuse the others.
TEST(DicomSeries, DamagedFilesAreLeftOut) {
  const SeriesFolder folder;
  folder.series(6, asIs);
  const std::string whole = dicomFile(ramp(50, {0, 0, 12}));
  std::string liar = whole;
  const std::size_t pixels = liar.find(std::string("\xe0\x7f\x10\x00OW", 6));
  std::memcpy(liar.data() + pixels + 8, "\xf0\xff\xff\x7f", 4);
  folder.write("DOE^JANE.dcm", liar), folder.write("short.dcm", whole.substr(0, whole.size() - 30));
  folder.write("notes.txt", "no picture");
  const LogRecord record;
  EXPECT_EQ(loadVolume(folder.path()).stored.geometry.dims.z, 6);
  EXPECT_TRUE(warned(record, "2 DICOM files are left out: damaged"));
  EXPECT_FALSE(warned(record, "DOE"));
  expectError([&] { readScan(folder / "short.dcm"); }, "longer than what is left");
}

TEST(DicomSeries, CanBeCancelledBetweenItsFiles) {
  const SeriesFolder folder;
  folder.series(20, asIs);
  ProgressSink sink;
  int reports = 0;
  sink.report = [&](double) { sink.cancel = ++reports == 5; };
  EXPECT_THROW(readDicomSeries(folder.path(), {}, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
