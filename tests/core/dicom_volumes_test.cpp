// Several times, echoes and series of DICOM in one folder: which of its slices are steps, and which are volumes of their own.
#include <gtest/gtest.h>

#include <cmath>

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
using test::numberAt;
using test::place;
using test::ramp;
using test::SeriesFolder;
using test::warned;

struct Step {
  const char* name;
  std::uint16_t group, element;
  const char* type;
  const char *first, *second;
};

TEST(DicomVolumes, TimesAreSteps) {
  for (const Step& s : {Step{"temporal position", 0x20, 0x100, "IS", "1", "2"},
                        {"acquisition", 0x20, 0x12, "IS", "4", "5"},
                        {"trigger", 0x18, 0x1060, "DS", "0", "250.5"},
                        {"acquired", 8, 0x32, "TM", "120000.5", "120003"},
                        {"content", 8, 0x33, "TM", "120000", "120003"}}) {  // of one acquisition
    SCOPED_TRACE(s.name);
    const SeriesFolder folder;
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
TEST(DicomVolumes, TimesOfOtherPlacesAreVolumes) {
  for (const int uneven : {0, 1}) {
    for (const glm::dvec3 off : {glm::dvec3(0, 0, 7.3), glm::dvec3(3, 0, 6)}) {
      const SeriesFolder folder;
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

TEST(DicomVolumes, TimesThatAreUnevenAlikeAreRefusedForThat) {
  const SeriesFolder folder;
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
TEST(DicomVolumes, OtherPicturesAreVolumes) {
  const SeriesFolder echoes, apart;
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

TEST(DicomVolumes, SeveralInAFolderAreAskedFor) {
  const SeriesFolder folder;
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
TEST(DicomVolumes, FilesOfSeveralFramesAreVolumes) {
  const SeriesFolder folder;
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

TEST(DicomVolumes, ScoutsAreLeftAsideWithAWord) {
  const SeriesFolder folder;
  folder.series(6, asIs);
  DicomImage scout = ramp(90, {0, -50, 0});
  scout.orientation = "0\\1\\0\\0\\0\\-1";
  folder.add("scout.dcm", scout);
  const LogRecord record;
  EXPECT_EQ(loadVolume(folder.path()).stored.geometry.dims.z, 6);
  EXPECT_TRUE(warned(record, "1 picture that is no slice"));
}

}  // namespace
}  // namespace sonoskin
