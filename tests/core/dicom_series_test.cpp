// Which slices of DICOM make a volume, and where they lie.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "core/base/log.h"
#include "core/io/dicom/dicom_series.h"
#include "core/io/volume_loader.h"
#include "core/io/volume_reader.h"
#include "tests/support/dicom.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::DicomImage;
using test::expectError;
using test::TempFolder;

constexpr int kColumns = 12, kRows = 10;

std::string place(const glm::dvec3& p) { return fmt::format("{:.6f}\\{:.6f}\\{:.6f}", p.x, p.y, p.z); }

// A slice whose numbers grow along the world's axes: 1000 + 10 x + 100 y + 30 z, x along rows and y along columns.
DicomImage ramp(int number, const glm::dvec3& origin) {
  DicomImage image;
  image.columns = kColumns, image.rows = kRows;
  image.number = number, image.position = place(origin);
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i)
      image.numbers.push_back(
          int(std::lround(1000 + 10 * (origin.x + 0.5 * i) + 100 * (origin.y + 0.5 * j) + 30 * origin.z)));
  return image;
}

struct Folder : TempFolder {
  void add(const std::string& name, const DicomImage& image) const { write(name, dicomFile(image)); }
  // Slices 2 mm apart, changed by `change(image, k)`.
  template <class Change>
  const fs::path& series(int count, const Change& change, const std::string& name = "s") const {
    for (int k = 0; k < count; ++k) {
      DicomImage image = ramp(k + 1, {0, 0, 2.0 * k});
      change(image, k);
      add(fmt::format("{}{:02}.dcm", name, k), image);
    }
    return path();
  }
};
const auto asIs = [](DicomImage&, int) {};

double numberAt(const LoadedVolume& v, int i, int j, int k) {
  const std::size_t n = v.stored.geometry.index(i, j, k);
  if (v.stored.type == NumberType::float32) {
    float value;
    std::memcpy(&value, v.numbers.data() + 4 * n, 4);
    return double(value);
  }
  EXPECT_EQ(v.stored.type, NumberType::uint16);
  std::uint16_t value;
  std::memcpy(&value, v.numbers.data() + 2 * n, 2);
  return value;
}

// That every voxel that was recorded has the number of its place in the world; how many there are.
int expectRamp(const LoadedVolume& v) {
  const Geometry& g = v.stored.geometry;
  int recorded = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const glm::dvec3 w = g.toWorld({i, j, k});
        const double number = numberAt(v, i, j, k);
        if (std::isnan(number)) continue;
        EXPECT_NEAR(number, 1000 + 10 * w.x + 100 * w.y + 30 * w.z, 0.6) << i << " " << j << " " << k;
        ++recorded;
      }
  return recorded;
}

bool warned(const LogRecord& record, const char* words) {
  for (const std::string& sentence : record.sentences(LogLevel::warning))
    if (sentence.find(words) != std::string::npos) return true;
  return false;
}

TEST(DicomSeries, LiesWhereItsSlicesDo) {
  const Folder folder;
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
    const Folder folder;
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
  const Folder folder;
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
    const Folder folder;
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
  const Folder folder;
  folder.series(12, [](DicomImage& image, int k) {
    image.position = place({0, 0, 2.0 * (k + (k > 4) + (k > 7))});
  });
  expectError([&] { readScan(folder.path()); }, "2 are missing, the first one after slice 5 of 12");
}

TEST(DicomSeries, OfUnevenDistancesSaysSo) {
  const Folder folder, growing;
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
  const Folder folder;
  folder.series(9, [](DicomImage& image, int k) { image.position = place({k == 4 ? 3.0 : 0, 0, 2.0 * k}); });
  expectError([&] { readScan(folder.path()); }, "shifted against each other");
}

TEST(DicomSeries, WithoutPlacesSaysSo) {
  const Folder folder;
  folder.series(9, [](DicomImage& image, int) { image.position = ""; });
  expectError([&] { readScan(folder.path()); }, "do not say where they lie");
  const Folder some;
  some.series(9, [](DicomImage& image, int k) {
    if (k > 6) image.position = "";
  });
  const LogRecord record;
  EXPECT_EQ(loadVolume(some.path()).stored.geometry.dims.z, 7);
  EXPECT_TRUE(warned(record, "2 of the series' 9 slices are left out"));
}

TEST(DicomSeries, AFileWithoutAPlaceIsNoPartOfItsSeries) {
  const Folder folder;
  folder.series(9, [](DicomImage& image, int k) {
    if (k == 3) image.position = "";
  });
  expectError([&] { readScan(folder / "s03.dcm"); }, "does not say where it lies");
}

TEST(DicomSeries, WithSlicesTwiceSaysSo) {
  const Folder folder;
  folder.series(6, asIs);
  folder.series(
      6, [](DicomImage& image, int) { image.number += 100; }, "t");
  expectError([&] { readScan(folder.path()); }, "2 slices at the same place, at 6 of its 6 places");
}

// The same instance under another name is a copy.
TEST(DicomSeries, CopiesOfFilesAreLeftOut) {
  const Folder folder;
  folder.series(6, asIs);
  folder.series(2, asIs, "copy");
  const LogRecord record;
  EXPECT_EQ(expectRamp(loadVolume(folder.path())), 6 * kColumns * kRows);
  EXPECT_TRUE(warned(record, "2 files are left out as copies"));
}

// Some programs give all slices the same UID.
TEST(DicomSeries, SlicesOfOneUidAreNoCopies) {
  const Folder folder, timed, unplaced;
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

struct Step {
  const char* name;
  std::uint16_t group, element;
  const char* type;
  const char *first, *second;
};

TEST(DicomSeries, TimesAreSteps) {
  for (const Step& s : {Step{"temporal position", 0x20, 0x100, "IS", "1", "2"},
                        {"acquisition", 0x20, 0x12, "IS", "4", "5"},
                        {"trigger", 0x18, 0x1060, "DS", "0", "250.5"},
                        {"acquired", 8, 0x32, "TM", "120000.5", "120003"},
                        {"content", 8, 0x33, "TM", "120000", "120003"}}) {  // of one acquisition
    SCOPED_TRACE(s.name);
    const Folder folder;
    const auto at = [&](const char* value, int shift) {
      return [=, &s](DicomImage& image, int) {
        image.others.push_back({s.group, s.element, s.type, value});
        if (s.element == 0x33) image.others.push_back({8, 0x32, "TM", "115959"});
        image.number += 10 * shift;
        for (std::int32_t& n : image.numbers) n += 500 * shift;
      };
    };
    folder.series(6, at(s.second, 1), "a");
    folder.series(6, at(s.first, 0), "b");
    const LoadedVolume v = loadVolume(folder.path());
    EXPECT_EQ(v.stored.timeSteps, 2);
    EXPECT_EQ(v.stored.geometry.dims.z, 6);
    EXPECT_NEAR(v.stored.stepSeconds, s.group == 0x18 ? 0.2505 : 0, 1e-9);
    expectRamp(v);
    EXPECT_EQ(numberAt(loadVolume(folder.path(), {0, 2}), 3, 2, 4), numberAt(v, 3, 2, 4) + 500);
    EXPECT_EQ(readVolumeInfo(folder / "a03.dcm").timeSteps, 2);
    expectError([&] { readScan(folder.path(), {0, 3}); }, "no step 3");
  }
}

// Only those that lie where the others do; of each that does not, what is wrong with it is told.
TEST(DicomSeries, TimesOfOtherPlacesAreVolumes) {
  for (const int uneven : {0, 1}) {
    for (const glm::dvec3 off : {glm::dvec3(0, 0, 7.3), glm::dvec3(3, 0, 6)}) {
      const Folder folder;
      for (int t = 0; t < 2; ++t)
        folder.series(
            6,
            [&](DicomImage& image, int k) {
              image.others.push_back({0x20, 0x100, "IS", std::to_string(t + 1)});
              image.number += 10 * t;
              if (t == uneven && k == 3) image.position = place(off);
            },
            t == 0 ? "a" : "b");
      const char* reason = off.x > 0 ? "shifted against each other" : "not evenly spaced: 0.7 to 3.3 mm";
      expectError([&] { readScan(folder.path()); }, "1: 12 x 10 x 6, CT; 2: 12 x 10 x 6, CT; choose");
      expectRamp(loadVolume(folder.path(), {2 - uneven}));
      expectError([&] { readScan(folder.path(), {1 + uneven}); }, reason);
    }
  }
}

TEST(DicomSeries, TimesThatAreUnevenAlikeAreRefusedForThat) {
  const Folder folder;
  for (int t = 0; t < 2; ++t)
    folder.series(
        6,
        [&](DicomImage& image, int k) {
          image.others.push_back({0x20, 0x100, "IS", std::to_string(t + 1)});
          image.number += 10 * t;
          if (k == 3) image.position = place({0, 0, 7.3});
        },
        t == 0 ? "a" : "b");
  expectError([&] { readScan(folder.path(), {0, 2}); }, "not evenly spaced");
}

// Other pictures of the same places, such as echoes, are volumes of their own; so are acquisitions elsewhere.
TEST(DicomSeries, OtherPicturesAreVolumes) {
  const Folder echoes, apart;
  for (int e = 0; e < 2; ++e)
    echoes.series(
        5,
        [&](DicomImage& image, int) {
          image.number += 10 * e, image.others.push_back({0x18, 0x81, "DS", e ? "80" : "20"});
        },
        std::to_string(e));
  expectError([&] { readScan(echoes.path()); },
              "holds 2 volumes: 1: 12 x 10 x 5, CT; 2: 12 x 10 x 5, CT; choose");
  EXPECT_EQ(readScan(echoes.path(), {2}).volume->geometry.dims.z, 5);
  EXPECT_EQ(readScan(echoes / "104.dcm").volume->geometry.dims.z, 5);
  for (int a = 0; a < 2; ++a)
    apart.series(
        5 + a,
        [&](DicomImage& image, int k) {
          image.number += 10 * a, image.position = place({0, 0, 2.0 * k + 4 * a});
          image.others.push_back({0x20, 0x12, "IS", std::to_string(a)});
        },
        std::to_string(a));
  expectError([&] { readScan(apart.path()); }, "1: 12 x 10 x 5, CT; 2: 12 x 10 x 6, CT");
}

TEST(DicomSeries, SeveralInAFolderAreAskedFor) {
  const Folder folder;
  folder.series(6, asIs);
  folder.series(
      4, [](DicomImage& image, int) { image.series += ".8", image.number += 50, image.modality = "MR"; },
      "t");
  expectError([&] { readScan(folder.path()); },
              "holds 2 volumes: 1: 12 x 10 x 6, CT; 2: 12 x 10 x 4, MR; choose one with scan.volume.");
  const auto entries = dicomVolumes(folder.path());
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entryText(entries[1]), "12 x 10 x 4, MR");
  EXPECT_EQ(readScan(folder.path(), {1}).volume->geometry.dims.z, 6);
  EXPECT_EQ(readScan(folder.path(), {2}).modality, "MR");
  EXPECT_EQ(readScan(folder / "t02.dcm").modality, "MR");  // a file stands for its series
  EXPECT_TRUE(dicomVolumes(folder / "t02.dcm").empty());
  expectError([&] { readScan(folder.path(), {3}); }, "there is no volume 3");
}

// Each chosen file is a volume, whatever lies beside it under the same series.
TEST(DicomSeries, FilesOfSeveralFramesAreVolumes) {
  const Folder folder;
  for (int f = 0; f < 2; ++f) {
    DicomImage image = ramp(f + 1, {0, 0, 0});
    image.frames = 3 + f;
    const auto slice = image.numbers;
    for (int k = 1; k < image.frames; ++k)
      image.numbers.insert(image.numbers.end(), slice.begin(), slice.end());
    image.others.push_back({0x18, 0x88, "DS", "0.75"});
    image.mediaStorage = "1.2.840.10008.5.1.4.1.1.3.1", image.modality = "US";
    folder.add(fmt::format("{}.dcm", f), image);
  }
  EXPECT_EQ(readScan(folder / "0.dcm").volume->geometry.dims.z, 3);
  EXPECT_EQ(readScan(folder / "1.dcm").volume->geometry.dims.z, 4);
  EXPECT_EQ(readScan(folder / "1.dcm").volume->geometry.spacing.z, 0.75);
  expectError([&] { readScan(folder.path()); }, "1: 12 x 10 x 3, US; 2: 12 x 10 x 4, US");
}

TEST(DicomSeries, ScoutsAreLeftAsideWithAWord) {
  const Folder folder;
  folder.series(6, asIs);
  DicomImage scout = ramp(90, {0, -50, 0});
  scout.orientation = "0\\1\\0\\0\\0\\-1";
  folder.add("scout.dcm", scout);
  const LogRecord record;
  EXPECT_EQ(loadVolume(folder.path()).stored.geometry.dims.z, 6);
  EXPECT_TRUE(warned(record, "1 picture that is no slice"));
}

TEST(DicomSeries, TellsOfTwoDistances) {
  const Folder folder;
  folder.series(6, [](DicomImage& image, int) { image.others.push_back({0x18, 0x88, "DS", "1.5"}); });
  const LogRecord record;
  EXPECT_EQ(loadVolume(folder.path()).stored.geometry.spacing.z, 2);
  EXPECT_TRUE(warned(record, "2 mm apart by their places, which are used, and 1.5 mm"));
}

// One damaged file of a folder is no reason to trust or to refuse the others.
TEST(DicomSeries, DamagedFilesAreLeftOut) {
  const Folder folder;
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
  const Folder folder;
  folder.series(20, asIs);
  ProgressSink sink;
  int reports = 0;
  sink.report = [&](double) { sink.cancel = ++reports == 5; };
  EXPECT_THROW(readDicomSeries(folder.path(), {}, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
