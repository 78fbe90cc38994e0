#include "core/io/volume_reader.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "core/base/parallel.h"
#include "core/io/volume_writer.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"
#include "tests/support/volumes.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::fileText;
using test::TempFolder;

// A raw NRRD of 2 x 3 x 4 numbers, with more lines in the header.
std::string nrrd(const std::string& type, const std::string& more, const std::string& data) {
  return "NRRD0004\ntype: " + type + "\ndimension: 3\nsizes: 2 3 4\nendian: little\nencoding: raw\n" + more +
         "\n" + data;
}
std::string mha(const std::string& dims, const std::string& more, const std::string& data) {
  return "ObjectType = Image\nNDims = 3\nDimSize = " + dims + "\nElementType = MET_UCHAR\n" + more +
         "ElementDataFile = LOCAL\n" + data;
}
template <class T>
std::string bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}
const std::string k24(24, '\x80');

TEST(ReadScan, FindsTheSpacingOrSaysThatThereIsNone) {
  const TempFolder folder;
  EXPECT_FALSE(readScan(folder.write("a.nrrd", nrrd("uint8", "", k24))).spacingKnown);
  EXPECT_TRUE(readScan(folder.write("b.nrrd", nrrd("uint8", "spacings: 1 2 3\n", k24))).spacingKnown);
  EXPECT_FALSE(readScan(folder.write("c.nrrd", nrrd("uint8", "spacings: 1 2 nan\n", k24))).spacingKnown);
  const std::string place = "space: left-posterior-superior\nspace directions: (1,0,0) (0,2,0) none\n";
  EXPECT_FALSE(readScan(folder.write("d.nrrd", nrrd("uint8", place, k24))).spacingKnown);
  EXPECT_FALSE(readScan(folder.write("a.mha", mha("2 3 4", "", k24))).spacingKnown);
  const Scan scan = readScan(folder.write("b.mha", mha("2 3 4", "ElementSpacing = 1 2 3\n", k24)));
  EXPECT_TRUE(scan.spacingKnown);
  EXPECT_EQ(scan.volume->geometry.spacing, glm::dvec3(1, 2, 3));
  EXPECT_NEAR(scan.volume->at(1, 2, 3), 128 / 255.0, 1e-6);
}

TEST(ReadScan, TurnsOtherFramesIntoLps) {
  const TempFolder folder;
  const Scan scan = readScan(folder.write(
      "a.nrrd", nrrd("uint8",
                     "space: right-anterior-superior\nspace directions: (2,0,0) (0,0,3) (0,4,0)\n"
                     "space origin: (10, 20, 30)\n",
                     k24)));
  const Geometry& g = scan.volume->geometry;
  EXPECT_EQ(g.spacing, glm::dvec3(2, 3, 4));
  EXPECT_LT(glm::distance(g.toWorld({1, 0, 0}), glm::dvec3(-12, -20, 30)), 1e-12);
  EXPECT_LT(glm::distance(g.toWorld({0, 0, 1}), glm::dvec3(-10, -24, 30)), 1e-12);
}

TEST(ReadScan, ReadsEveryNumberTypeAndByteOrder) {
  const TempFolder folder;
  std::vector<std::int16_t> shorts;
  std::vector<double> doubles;
  for (int n = 0; n < 24; ++n) {
    shorts.push_back(std::int16_t(100 * n - 1000));
    doubles.push_back(100 * n - 1000);
  }
  std::string swapped = bytesOf(shorts);
  for (std::size_t b = 0; b < swapped.size(); b += 2) std::swap(swapped[b], swapped[b + 1]);
  std::string text;
  for (const std::int16_t v : shorts) text += std::to_string(v) + "\n";
  std::string big = nrrd("int16", "", swapped), written = nrrd("int16", "", text);
  big.replace(big.find("little"), 6, "big");
  written.replace(written.find("raw"), 3, "text");
  for (const auto& path :
       {folder.write("a.nrrd", nrrd("int16", "", bytesOf(shorts))), folder.write("b.nrrd", big),
        folder.write("c.nrrd", nrrd("double", "", bytesOf(doubles))), folder.write("d.nrrd", written)}) {
    const Scan scan = readScan(path);
    for (int n = 0; n < 24; ++n) EXPECT_NEAR(scan.volume->data[std::size_t(n)], n / 23.0, 1e-6) << path;
    EXPECT_EQ(scan.originalMin, -1000);
    EXPECT_EQ(scan.originalMax, 1300);
  }
}

TEST(ReadScan, StrayValuesNeitherDarkenNorBreak) {
  const TempFolder folder;
  Geometry g;
  g.dims = {20, 20, 20};
  auto volume = test::filledVolume<float>(g);
  volume.data[5] = 1e30f;
  volume.data[6] = std::numeric_limits<float>::quiet_NaN();
  volume.data[7] = -std::numeric_limits<float>::infinity();
  writeVolume(folder / "a.vtk", volume);
  const Scan scan = readScan(folder / "a.vtk");
  EXPECT_LT(scan.originalMax, 1.01);
  EXPECT_EQ(scan.volume->data[5], 1);
  EXPECT_EQ(scan.volume->data[6], 0);
  EXPECT_EQ(scan.volume->data[7], 0);
  EXPECT_NEAR(scan.volume->data[4000], 0.5, 0.01);
}

TEST(ReadScan, TakesTheTimeStepAskedForAndTheLuminanceOfColour) {
  const TempFolder folder;
  const std::string head = "NRRD0004\ntype: uint8\ndimension: 4\nencoding: raw\n";
  const auto last = folder.write("last.nrrd", head + "sizes: 2 3 4 5\nkinds: domain domain domain time\n\n" +
                                                  k24 + std::string(96, '\0'));
  EXPECT_EQ(readVolumeInfo(last).timeSteps, 5);
  EXPECT_NEAR(readScan(last).volume->data[23], 128 / 255.0, 1e-6);
  EXPECT_EQ(readScan(last, {.time = 5}).volume->data[23], 0);
  expectError([&] { readScan(last, {.time = 6}); }, "there is no step 6");
  expectError([&] { readScan(last, {.volume = 2}); }, "there is no volume 2");
  std::string pairs, colours;
  for (int n = 0; n < 24; ++n) {
    pairs += "\x80\x01";
    colours += "\xff\x80\x10";
  }
  const auto first =
      folder.write("first.nrrd", head + "sizes: 2 2 3 4\nkinds: list domain domain domain\n\n" + pairs);
  EXPECT_EQ(readVolumeInfo(first).timeSteps, 2);
  EXPECT_NEAR(readScan(first).volume->data[23], 128 / 255.0, 1e-6);
  EXPECT_NEAR(readScan(first, {.time = 2}).volume->data[23], 1 / 255.0, 1e-6);
  const auto rgb =
      folder.write("rgb.nrrd", head + "sizes: 3 2 3 4\nkinds: RGB-color domain domain domain\n\n" + colours);
  EXPECT_EQ(readVolumeInfo(rgb).components, 3);
  EXPECT_NEAR(readScan(rgb).volume->data[23], (0.2126 * 255 + 0.7152 * 128 + 0.0722 * 16) / 255, 1e-6);
  const auto field =
      folder.write("field.nrrd", head + "sizes: 2 2 3 4\nkinds: vector domain domain domain\n\n" + pairs);
  expectError([&] { readScan(field); }, "2 numbers per voxel");
}

// A NIfTI without packing, of a volume that ITK has written.
std::string plainNifti(const TempFolder& folder, const Volume<std::uint8_t>& volume) {
  writeVolume(folder / "plain.nii.gz", volume);
  std::string bytes(352 + volume.data.size(), '\0');
  const gzFile file = gzopen((folder / "plain.nii.gz").c_str(), "rb");
  gzread(file, bytes.data(), unsigned(bytes.size()));
  gzclose(file);
  return bytes;
}

TEST(ReadScan, NiftiIsTurnedFromRasAndScaled) {
  const TempFolder folder;
  const auto volume =
      test::filledVolume<std::uint8_t>(Geometry{{4, 3, 2}, {1, 2, 3}, {5, 6, 7}, glm::dmat3(1)});
  std::string bytes = plainNifti(folder, volume);
  float offset[3];  // the quaternion's, in RAS
  std::memcpy(offset, bytes.data() + 268, sizeof offset);
  EXPECT_EQ(glm::vec3(offset[0], offset[1], offset[2]), glm::vec3(-5, -6, 7));
  const float slope = 2, intercept = -10;
  std::memcpy(bytes.data() + 112, &slope, sizeof slope);
  std::memcpy(bytes.data() + 116, &intercept, sizeof intercept);
  const auto path = folder.write("scaled.nii", bytes);
  const auto [least, most] = std::minmax_element(volume.data.begin(), volume.data.end());
  const VolumeInfo info = readVolumeInfo(path);
  EXPECT_EQ(info.valueMin, 2.0 * *least - 10);
  EXPECT_EQ(info.valueMax, 2.0 * *most - 10);
  EXPECT_LT(glm::distance(info.geometry.toWorld({0, 0, 0}), glm::dvec3(5, 6, 7)), 1e-6);
}

TEST(ReadScan, ReadsDetachedHeadersOfTheSameFolderOnly) {
  const TempFolder folder;
  folder.write("a.raw", k24);
  EXPECT_EQ(readScan(folder.write("a.nhdr", nrrd("uint8", "data file: a.raw\n", ""))).volume->data.size(),
            24u);
  for (const char* name : {"../a.raw", "/etc/passwd", "sub/../../a.raw", ".."})
    expectError(
        [&] {
          readScan(folder.write("b.nhdr", nrrd("uint8", std::string("data file: ") + name + "\n", "")));
        },
        "outside of its own folder");
  std::string head = mha("2 3 4", "", "");
  head.replace(head.find("LOCAL"), 5, "../a.raw");
  expectError([&] { readScan(folder.write("b.mhd", head)); }, "outside of its own folder");
  head.replace(head.find("../a.raw"), 8, "none.raw");
  expectError([&] { readScan(folder.write("c.mhd", head)); }, "not beside it");
}

TEST(ReadScan, RefusesWhatIsNoVolume) {
  const TempFolder folder;
  expectError([&] { readScan(folder / "none.nrrd"); }, "no file");
  expectError([&] { readScan(folder.path()); }, "no DICOM series");
  expectError([&] { readScan(folder.write("a.nrrd", "")); }, "empty");
  expectError([&] { readScan(folder.write("a.txt", "hello")); }, "format");
  expectError(
      [&] { readScan(folder.write("a.nrrd", "NRRD0004\ntype: uint8\ndimension: 16\nsizes: 1 1 1 1\n\n")); },
      "16 dimensions");
  expectError(
      [&] { readScan(folder.write("a.nrrd", "NRRD0004\ntype: uint8\ndimension: 2\nsizes: 4 4\n\n")); },
      "2 dimensions");
  expectError([&] { readScan(folder.write("b.mha", mha("4 4 1", "", k24))); }, "flat picture");
  expectError([&] { readScan(folder.write("b.mha", mha("4 4 -3", "", k24))); }, "-3 voxels");
  expectError([&] { readScan(folder.write("b.mha", mha("2 3", "", k24))); }, "DimSize");
  expectError([&] { readScan(folder.write("b.mha", "ObjectType = Image\nNDims = 3\n")); }, "not a complete");
}

TEST(ReadScan, RefusesGeometryThatMakesNoSense) {
  const TempFolder folder;
  const auto with = [&](const std::string& line) {
    return [&folder, line] { readScan(folder.write("a.mha", mha("2 3 4", line + "\n", k24))); };
  };
  expectError(with("ElementSpacing = 1 -1 1"), "spacing");
  expectError(with("ElementSpacing = 1 nan 1"), "spacing");
  expectError(with("ElementSpacing = 1 0 1"), "spacing");
  expectError(with("ElementSpacing = 1 inf 1"), "spacing");
  // Lengths that no scan of a body has: another unit, or damage.
  for (const char* sizes : {"1e300 1 1", "1e12 1e12 1e12", "1e4 1e4 1e4", "1e-9 1e-9 1e-9", "1e-3 1 500"})
    expectError(with(std::string("ElementSpacing = ") + sizes), "which no scan of a body has");
  expectError(with("ElementSpacing = 1 one 1"), "spacing");
  expectError(with("Offset = 0 inf 0"), "origin");
  expectError(with("TransformMatrix = 1 0 0 1 1 0 0 0 1"), "right angles");
  expectError(with("TransformMatrix = 0 0 0 0 0 0 0 0 0"), "right angles");
  expectError(with("TransformMatrix = nan 0 0 0 1 0 0 0 1"), "finite");
  expectError(
      [&] {
        readScan(folder.write("a.nrrd", nrrd("uint8", "space directions: (1,0,0) (0,0,0) (0,0,1)\n", k24)));
      },
      "");
}

// Each of these makes the parsers of ITK 5.2 write beyond their arrays, or read what the header does not say.
TEST(ReadScan, BearsWhatItkCannot) {
  const TempFolder folder;
  const auto meta = [&](const std::string& more) {
    return [&folder, more] { readScan(folder.write("a.mha", mha("2 3 4", more, k24))); };
  };
  EXPECT_NO_THROW(meta("Comment = " + std::string(5000, 'x') + "\n")());
  expectError(meta("AnatomicalOrientation = RAIRAIRAIRAI\n"), "one letter per axis");
  expectError(meta("NDims = 10\n"), "there twice");
  expectError(meta("NDims : 10 = 10\n"), "different ways");
  expectError(meta("Name = a\rNDims = 10\n"), "not text");
  expectError(meta("CompressedData = True\n"), "damaged");
  expectError(meta("CompressedData = True\nCompressedDataSize = 99999\n"), "ends before");
  expectError(meta("BinaryData = False\n"), "ends before");
  const auto nrrds = [&](const std::string& more) {
    return [&folder, more] { readScan(folder.write("a.nrrd", nrrd("uint8", more, k24))); };
  };
  expectError(nrrds("space dimension: 8\nspace origin: (1,2,3,4,5,6,7,8)\n"), "three dimensions");
  expectError(nrrds("space: 3D-right-handed-time\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"),
              "vectors of 4");
  expectError(nrrds("dimension: 16\n"), "twice");
  expectError(nrrds("# a\rdimension: 16\n"), "not text");
}

TEST(ReadScan, RefusesHugeHeadersAtOnce) {
  const TempFolder folder;
  const auto begin = std::chrono::steady_clock::now();
  expectError([&] { readScan(folder.write("a.mha", mha("65535 65535 65535", "", "x"))); }, "more than fit");
  expectError([&] { readScan(folder.write("a.mha", mha("99999999999 2 2", "", "x"))); },
              "voxels along one axis");
  expectError([&] { readScan(folder.write("a.mha", mha("1000 1000 1000", "", "x"))); }, "ends before");
  expectError([&] { readScan(folder.write("a.mha", mha("1000 1000 1000", "CompressedData = True\n", "x"))); },
              "ends before");
  expectError([&] { readScan(folder.write("a.mha", mha("1000 1000 1000", "HeaderSize = -1\n", "x"))); },
              "ends before");
  expectError(
      [&] { readScan(folder.write("a.mha", mha("2 3 4", "ElementNumberOfChannels = 99999999\n", k24))); },
      "");
  expectError(
      [&] { readScan(folder.write("a.nrrd", nrrd("uint8", "byte skip: 9000000000000000000\n", k24))); },
      "ends before");
  expectError([&] { readScan(folder.write("a.nrrd", nrrd("uint8", "byte skip: -5\n", k24))); }, "byte skip");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

TEST(ReadScan, FindsTruncatedAndDamagedDataInEveryFormat) {
  const TempFolder folder;
  Geometry g;
  g.dims = {24, 20, 16};
  Volume<std::uint8_t> volume(g);
  std::mt19937 random(1);
  for (auto& v : volume.data) v = std::uint8_t(random());
  for (const std::string extension : {".nrrd", ".mha", ".nii.gz", ".vtk"}) {
    writeVolume(folder / ("good" + extension), volume);
    const std::string bytes = fileText(folder / ("good" + extension));
    for (const double part : {0.05, 0.5, 0.99}) {
      const auto cut =
          folder.write("cut" + extension, bytes.substr(0, std::size_t(part * double(bytes.size()))));
      expectError([&] { readScan(cut); }, "");
    }
    if (extension == ".vtk") continue;
    std::string damaged = bytes;
    for (std::size_t b = bytes.size() / 2; b < bytes.size() / 2 + 64; ++b)
      damaged[b] = char(damaged[b] ^ 0x5a);
    expectError([&] { readScan(folder.write("damaged" + extension, damaged)); }, "");
  }
}

TEST(ReadScan, StopsWhenCancelled) {
  const TempFolder folder;
  ProgressSink sink;
  sink.report = [&](double) { sink.cancel = true; };
  const auto path = folder.write("a.nrrd", nrrd("uint8", "", k24));
  EXPECT_THROW(readScan(path, {}, Progress(sink)), Cancelled);
}

// The same with headers alone, which no checksum protects.
TEST(ReadScan, SurvivesDamagedHeaders) {
  const TempFolder folder;
  std::mt19937 random(20251122);
  const std::string place = "space: left-posterior-superior\nspace directions: (1,0,0) (0,2,0) (0,0,3)\n";
  const std::string more =
      "BinaryData = True\nOffset = 1 2 3\nElementSpacing = 1 2 3\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n";
  const std::string letters = "0123456789 -.:=,()\n\rabcdefNDimSize";
  int read = 0;
  setThreadCount(1);
  for (const auto& [name, good] : {std::pair<std::string, std::string>{"a.nrrd", nrrd("uint8", place, k24)},
                                   {"a.mha", mha("2 3 4", more, k24)}})
    for (int round = 0; round < 300; ++round) {
      std::string bytes = good;
      const auto flips = 1 + random() % 3;
      for (unsigned f = 0; f < flips; ++f) {
        const std::size_t at = random() % (bytes.size() - 24);
        if (random() % 2)
          bytes[at] = letters[random() % letters.size()];
        else
          bytes.insert(at, bytes.substr(random() % (bytes.size() - 24), random() % 30));
      }
      try {
        readScan(folder.write(name, bytes));
        ++read;
      } catch (const Error&) {
      }
    }
  setThreadCount(0);
  EXPECT_GT(read, 20);
}

// Whatever bytes a file has: a volume, or one Error; no crash, no other exception, no long wait.
TEST(ReadScan, SurvivesRandomDamage) {
  const TempFolder folder;
  std::mt19937 random(20240607);
  const auto volume = test::filledVolume<std::uint8_t>(Geometry{{4, 3, 2}, {1, 2, 3}, {}, glm::dmat3(1)});
  int refused = 0, read = 0;
  setThreadCount(1);  // a team of threads costs more than these volumes
  for (const std::string extension : {".nrrd", ".mha", ".nii.gz", ".nii", ".vtk"}) {
    std::string good;
    if (extension == ".nii") {
      good = plainNifti(folder, volume);
    } else {
      writeVolume(folder / ("a" + extension), volume);
      good = fileText(folder / ("a" + extension));
    }
    for (int round = 0; round < 150; ++round) {
      std::string bytes = good;
      const auto flips = 1 + random() % 6;
      for (unsigned f = 0; f < flips; ++f) bytes[random() % bytes.size()] = char(random());
      if (round % 7 == 0) bytes.resize(random() % bytes.size() + 1);
      try {
        readScan(folder.write("b" + extension, bytes));
        ++read;
      } catch (const Error&) {
        ++refused;
      }
    }
  }
  setThreadCount(0);
  EXPECT_GT(refused, 100);
  EXPECT_GT(read, 50);
}

}  // namespace
}  // namespace sonoskin
