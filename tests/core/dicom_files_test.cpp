// Files of DICOM that another program has written (tests/tools/make_dicom.py), each read as it was told.
#include <gtest/gtest.h>

#include <cstring>

#include "core/base/log.h"
#include "core/io/dicom/dicom_series.h"
#include "core/io/volume_loader.h"
#include "core/io/volume_reader.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::expectError;

fs::path file(const std::string& name) { return fs::path(SONOSKIN_TEST_DATA) / "dicom" / (name + ".dcm"); }

// What make_dicom.py puts into a voxel.
int voxel(int i, int j, int k, int t = 0) { return (7 * i + 13 * j + 29 * k + 50 * t) % 251; }

void expectPlace(const LoadedVolume& v, const glm::ivec3& dims, const glm::dvec3& spacing,
                 const glm::dvec3& origin) {
  EXPECT_EQ(v.stored.geometry.dims, dims);
  EXPECT_NEAR(glm::length(v.stored.geometry.spacing - spacing), 0, 1e-9);
  EXPECT_NEAR(glm::length(v.stored.geometry.origin - origin), 0, 1e-9);
  EXPECT_TRUE(v.stored.spacingKnown);
}

// Bytes as the script made them, of a step of time or kind.
void expectVoxels(const LoadedVolume& v, int t = 0) {
  const glm::ivec3 d = v.stored.geometry.dims;
  ASSERT_EQ(v.stored.type, NumberType::uint8);
  ASSERT_EQ(v.numbers.size(), v.stored.geometry.voxels());
  for (int k = 0; k < d.z; ++k)
    for (int j = 0; j < d.y; ++j)
      for (int i = 0; i < d.x; ++i)
        ASSERT_EQ(int(v.numbers[v.stored.geometry.index(i, j, k)]), voxel(i, j, k, t))
            << i << " " << j << " " << k;
}

std::string warnings(const LogRecord& record) {
  std::string all;
  for (const std::string& sentence : record.sentences(LogLevel::warning)) all += sentence + "\n";
  return all;
}

TEST(DicomFiles, EnhancedUltrasoundIsSortedInSpaceAndTime) {
  const LogRecord record;
  for (int t = 0; t < 2; ++t) {
    const LoadedVolume v = loadVolume(file("enhanced_us"), {0, t + 1});
    expectPlace(v, {6, 4, 5}, {0.2, 0.3, 0.8}, {10, -5, 2});
    EXPECT_EQ(v.stored.geometry.direction, glm::dmat3({0, 1, 0}, {0, 0, 1}, {1, 0, 0}));
    EXPECT_EQ(v.stored.timeSteps, 2);
    expectVoxels(v, 2 * t);
    ASSERT_TRUE(v.stored.beam && v.stored.beam->apex);
    EXPECT_NEAR(glm::length(*v.stored.beam->apex - glm::dvec3(11.6, -40, 2.6)), 0, 1e-12);
    EXPECT_NEAR(glm::length(v.stored.beam->axis - glm::dvec3(0, 1, 0)), 0, 1e-12);
    EXPECT_NEAR(glm::length(v.stored.beam->up - glm::dvec3(0, 0, 1)), 0, 1e-12);
  }
  EXPECT_EQ(warnings(record), "");
  EXPECT_EQ(readScan(file("enhanced_us")).modality, "US");
}

TEST(DicomFiles, AnIndexTellsTimeWhereNothingElseDoes) {
  for (int t = 0; t < 2; ++t) {
    const LoadedVolume v = loadVolume(file("enhanced_us_index"), {0, t + 1});
    expectPlace(v, {6, 4, 5}, {0.2, 0.3, 0.9}, {1, 2, -3});
    EXPECT_EQ(v.stored.timeSteps, 2);
    expectVoxels(v, t);
  }
}

TEST(DicomFiles, TissueIsReadWhereFlowLiesBesideIt) {
  const LogRecord record;
  expectVoxels(loadVolume(file("enhanced_us_flow")), 0);
  EXPECT_EQ(record.sentences(LogLevel::info),
            std::vector<std::string>{
                "The scan holds 2 volumes: 1: 6 x 4 x 5, US; 2: 6 x 4 x 5, US; that of tissue is used."});
  expectVoxels(loadVolume(file("enhanced_us_flow"), {2, 1}), 1);
  EXPECT_EQ(dicomVolumes(file("enhanced_us_flow")).size(), 2u);
}

TEST(DicomFiles, EnhancedCtHasAScaleForEachFrame) {
  const LoadedVolume v = loadVolume(file("enhanced_ct"));
  expectPlace(v, {5, 4, 3}, {0.25, 0.5, 1.5}, {1, 2, 27});
  ASSERT_EQ(v.stored.type, NumberType::int32);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 5; ++i) {
        std::int32_t number;
        std::memcpy(&number, v.numbers.data() + 4 * v.stored.geometry.index(i, j, k), 4);
        ASSERT_EQ(number, 4 * voxel(i, j, 2 - k) * (3 - k) - 1000);
      }
}

TEST(DicomFiles, FramesOfUltrasoundHaveTheDistanceTheyAreTold) {
  expectPlace(loadVolume(file("us_spacing")), {8, 6, 4}, {0.2, 0.3, 0.75}, {0, 0, 0});
}

TEST(DicomFiles, RegionsOfUltrasoundAreInCentimetres) {
  const LogRecord record;
  expectPlace(loadVolume(file("us_regions")), {8, 6, 4}, {0.2, 0.3, 0.75}, {0, 0, 0});
  EXPECT_NE(warnings(record).find("burnt into its pictures"), std::string::npos);
}

// What lies outside of the picture can be left out, such as names that are burnt in.
TEST(DicomFiles, WhatLiesOutsideOfTheRegionCanBeBlanked) {
  ReadOptions options;
  options.regionOnly = true;
  const LogRecord record;
  const LoadedVolume v = loadVolume(file("us_regions"), options);
  EXPECT_EQ(warnings(record), "");
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 8; ++i) {
        const bool inside = i >= 1 && i <= 6 && j >= 1 && j <= 5;
        ASSERT_EQ(int(v.numbers[v.stored.geometry.index(i, j, k)]), inside ? voxel(i, j, k) | 1 : 0);
      }
  loadVolume(file("us_spacing"), options);
  EXPECT_NE(warnings(record).find("nothing is blanked"), std::string::npos);
}

// Milliseconds are no millimetres.
TEST(DicomFiles, AFilmIsNoVolume) {
  expectError([] { readScan(file("us_film")); }, "is a film: its 4 frames follow each other in time");
}

TEST(DicomFiles, MakersVolumesAreRead) {
  const LogRecord record;
  for (int t = 0; t < 2; ++t) {
    const LoadedVolume v = loadVolume(file("qlab"), {0, t + 1});
    expectPlace(v, {6, 4, 5}, {0.5, 0.6, 0.7}, {0, 0, 0});
    EXPECT_EQ(v.stored.timeSteps, 2);
    EXPECT_NEAR(v.stored.stepSeconds, 0.05, 1e-12);
    expectVoxels(v, t);
  }
  for (const char* name : {"affinity", "iu22"}) {
    const LoadedVolume v = loadVolume(file(name));
    expectPlace(v, {6, 4, 5}, {0.41, 0.52, 0.63}, {0, 0, 0});
    expectVoxels(v);
  }
  expectPlace(loadVolume(file("eigen")), {6, 4, 5}, glm::dvec3(0.35), -0.175 * glm::dvec3(5, 3, 4));
  EXPECT_EQ(warnings(record), "");
}

TEST(DicomFiles, WhatOnlyTheMakerReadsIsToldHowToBeExported) {
  expectError([] { readScan(file("movie_group")); }, "export it there as Cartesian DICOM");
  expectError([] { readScan(file("philips_native")); }, "export it from QLAB");
  expectError([] { readScan(file("encapsulated_stl")); }, "holds a mesh (STL), not a volume");
}

// The same pixels in all their coats: 40 + 8 i + 3 j + 10 k.
void expectSmooth(const std::string& name, double most, double tolerance) {
  SCOPED_TRACE(name);
  const Scan scan = readScan(file(name));
  const Geometry& g = scan.volume->geometry;
  ASSERT_EQ(g.dims, glm::ivec3(16, 16, 3));
  EXPECT_NEAR(g.spacing.z, 2, 1e-12);
  double worst = 0;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 16; ++j)
      for (int i = 0; i < 16; ++i)
        worst = std::max(worst,
                         std::abs(double(scan.volume->at(i, j, k)) * most - (40 + 8 * i + 3 * j + 10 * k)));
  EXPECT_LE(worst, tolerance);
}

TEST(DicomFiles, PixelsAreTheSameInAllTheirCoats) {
  constexpr double kByte = 255, kWide = 65535.0 / 200, kExact = 1e-3, kLossy = 4;
  for (const char* name :
       {"plain", "deflated", "planes", "ybr_full", "ybr_pairs", "palette", "jpeg2000_rct", "rle_colour"})
    expectSmooth(name, kByte, kExact);
  for (const char* name : {"wide", "big_endian", "jpeg2000", "jpeg2000_pieces",
                           "jpeg2000_pieces_without_table", "jpeg_lossless", "jpeg_ls", "rle"})
    expectSmooth(name, kWide, kExact);
  for (const char* name : {"jpeg_grey", "jpeg_ybr422"}) expectSmooth(name, kByte, kLossy);
}

TEST(DicomFiles, JpegOfTwelveBitsIsAsItsOwnDecoderHasIt) {
  const Scan scan = readScan(file("jpeg_extended")), plain = readScan(file("jpeg_extended_plain"));
  ASSERT_EQ(scan.volume->data.size(), 3u * 16 * 16);
  for (std::size_t v = 0; v < scan.volume->data.size(); ++v)
    ASSERT_NEAR(scan.volume->data[v], plain.volume->data[v], 1e-3) << v;
}

// The stream says what the file around it does not.
TEST(DicomFiles, JpegSaysItsColoursItself) {
  expectSmooth("jpeg_called_rgb", 255, 4);
  expectSmooth("jpeg_bare_420", 255, 4);
}

// What GDCM would read beyond its end.
TEST(DicomFiles, PackedPixelsAreAsLargeAsTheFileSays) {
  for (const char* name : {"jpeg_other_size", "jpeg2000_boxed_other_size", "jpeg2000_called_8",
                           "jpeg_lossless_called_8", "jpeg_ls_called_8"}) {
    SCOPED_TRACE(name);
    expectError([&] { readScan(file(name)); }, "packed pixels of another size");
  }
}

// Many programs put the whole of a JP2 file into a frame.
TEST(DicomFiles, Jpeg2000MayLieInBoxes) { expectSmooth("jpeg2000_boxed", 255, 1e-3); }

// Those take hardly any bytes.
TEST(DicomFiles, BlankSlicesAreKept) {
  const Scan scan = readScan(file("jpeg2000_blank"));
  ASSERT_EQ(scan.volume->geometry.dims, glm::ivec3(512, 512, 3));
  for (int k = 0; k < 3; ++k) EXPECT_EQ(scan.volume->at(200, 100, k) > scan.volume->at(0, 0, 0), k == 1);
}

TEST(DicomFiles, ADirectoryListsTheVolumesOfItsFiles) {
  const fs::path folder = fs::path(SONOSKIN_TEST_DATA) / "dicom/file_set";
  for (const fs::path& path : {folder, folder / "DICOMDIR"}) {
    EXPECT_EQ(entriesText(dicomVolumes(path)), "1: 5 x 4 x 4, CT; 2: 5 x 4 x 3, CT");
    expectError([&] { readScan(path); }, "choose one with scan.volume");
    expectVoxels(loadVolume(path, {2}));
  }
}

// As where files were gathered from a disc without their folders.
TEST(DicomFiles, ADirectoryThatIsOutOfDateDoesNotHideTheFilesBesideIt) {
  const fs::path folder = fs::path(SONOSKIN_TEST_DATA) / "dicom/file_set";
  for (const bool damaged : {false, true}) {
    const test::TempFolder flat;
    fs::copy_file(folder / "DICOMDIR", flat / "DICOMDIR");
    if (damaged) fs::resize_file(flat / "DICOMDIR", 400);
    if (!damaged) expectError([&] { readScan(flat / "DICOMDIR"); }, "names no files that are there");
    int copied = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().filename() != "DICOMDIR")
        fs::copy_file(entry.path(), flat / fmt::format("copy{}", ++copied));
    ASSERT_EQ(copied, 7);
    for (const fs::path& path : {flat.path(), flat / "DICOMDIR"}) {
      const LogRecord record;
      expectVoxels(loadVolume(path, {2}));
      EXPECT_NE(warnings(record).find("those beside it are taken"), std::string::npos);
    }
  }
}

TEST(DicomFiles, NothingOfThePatientIsSaid) {
  const LogRecord record;
  std::string told;
  for (const auto& entry : fs::directory_iterator(fs::path(SONOSKIN_TEST_DATA) / "dicom")) try {
      const VolumeInfo info = readVolumeInfo(entry.path());
      told += info.format + info.numberType + readScan(entry.path()).modality;
    } catch (const Error& error) {
      told += error.what();
    }
  told += warnings(record);
  for (const std::string& sentence : record.sentences(LogLevel::info)) told += sentence;
  for (const char* secret : {"PLANTED", "19990909", "1.2.826"})
    EXPECT_EQ(told.find(secret), std::string::npos) << told;
}

}  // namespace
}  // namespace sonoskin
