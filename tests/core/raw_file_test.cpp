#include "core/io/scanners/raw_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/base/log.h"
#include "core/io/volume_reader.h"
#include "tests/support/expect_error.h"
#include "tests/support/kretz.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::ramp;
using test::TempFolder;

ReadOptions told(const std::array<int, 3>& dims) {
  ReadOptions options;
  options.raw.dims = dims;
  return options;
}
std::string text(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

TEST(RawFile, AsksWhatIsInIt) {
  const TempFolder folder;
  const auto file = folder.write("a.raw", std::string(64 * 64 * 64, 'x'));
  EXPECT_TRUE(needsRawOptions(file, {}));
  EXPECT_FALSE(needsRawOptions(file, told({64, 64, 64}).raw));
  EXPECT_FALSE(needsRawOptions("a.nrrd", {}));
  EXPECT_FALSE(needsRawOptions(folder.write("b.raw", "NRRD0004\n"), {}));
  expectError([&] { readScan(file); }, "give raw.dims", Error::Kind::usage);
  expectError([&] { readScan(file); }, "64x64x64 of uint8", Error::Kind::usage);
}

TEST(RawFile, GuessesWhatHasItsSize) {
  const auto holds = [](const std::vector<RawGuess>& guesses, std::array<int, 3> dims, NumberType type) {
    for (const RawGuess& guess : guesses)
      if (guess.dims == dims && guess.type == type) return true;
    return false;
  };
  for (const RawGuess& guess : guessRaw(128 * 128 * 128))
    EXPECT_EQ(std::uintmax_t(guess.dims[0]) * std::uintmax_t(guess.dims[1]) * std::uintmax_t(guess.dims[2]) *
                  numberTypeBytes(guess.type),
              128u * 128 * 128);
  EXPECT_TRUE(holds(guessRaw(128 * 128 * 128), {128, 128, 128}, NumberType::uint8));
  EXPECT_TRUE(holds(guessRaw(512 * 512 * 90 * 2), {512, 512, 90}, NumberType::uint16));
  EXPECT_TRUE(guessRaw(1000003).empty());  // a prime
  EXPECT_TRUE(guessRaw(0).empty());
}

TEST(RawFile, TakesNumbersAsTheyAreTold) {
  const TempFolder folder;
  ReadOptions options = told({4, 3, 2});
  EXPECT_EQ(text(readRawFile(folder.write("a.raw", ramp(24)), options).numbers), ramp(24));
  EXPECT_FALSE(readRawFile(folder / "a.raw", options).stored.spacingKnown);
  options.raw.spacing = {0.5, 1, 2};
  EXPECT_EQ(readRawFile(folder / "a.raw", options).stored.geometry.spacing, glm::dvec3(0.5, 1, 2));
  options.raw.header = 6;
  EXPECT_EQ(text(readRawFile(folder.write("b.raw", "header" + ramp(24)), options).numbers), ramp(24));
  options.raw.header = -1;
  EXPECT_EQ(text(readRawFile(folder / "b.raw", options).numbers), ramp(24));
  options.raw.header = 0;
  options.raw.timeSteps = 3;
  options.time = 2;
  EXPECT_EQ(text(readRawFile(folder.write("c.raw", ramp(72)), options).numbers), ramp(24, 24));
  EXPECT_EQ(readRawFile(folder / "c.raw", options).stored.timeSteps, 3);
  options.time = 4;
  expectError([&] { readRawFile(folder / "c.raw", options); }, "no step 4");
}

TEST(RawFile, TakesEveryTypeAndByteOrder) {
  const TempFolder folder;
  std::string floats;
  for (int n = 0; n < 8; ++n) {
    const float value = float(n) / 7;
    char bytes[4];
    std::memcpy(bytes, &value, 4);
    for (int b = 3; b >= 0; --b) floats += bytes[b];
  }
  ReadOptions options = told({2, 2, 2});
  options.raw.type = NumberType::float32;
  options.raw.byteOrder = ByteOrder::big;
  const Scan scan = readScan(folder.write("a.bin", floats), options);
  EXPECT_NEAR(scan.volume->data[3], 3 / 7.0, 1e-6);
}

TEST(RawFile, MustHoldWhatItIsTold) {
  const TempFolder folder;
  const auto file = folder.write("a.img", ramp(24));
  expectError([&] { readRawFile(file, told({4, 3, 3})); }, "has 24 bytes");
  expectError([&] { readRawFile(file, told({65535, 65535, 65535})); }, "more than fit");
  expectError([&] { readRawFile(file, told({24, 1, 1})); }, "2 to 65535");
  ReadOptions options = told({4, 3, 2});
  options.raw.header = 1;
  expectError([&] { readRawFile(file, options); }, "after 1 bytes");
  LogRecord record;
  readRawFile(file, told({2, 3, 2}));
  ASSERT_EQ(record.sentences(LogLevel::warning).size(), 1u);
  EXPECT_NE(record.sentences(LogLevel::warning)[0].find("as much as 1 time steps more"), std::string::npos);
}

TEST(RawFile, IsWhatItSaysWhereItHasAMark) {
  const TempFolder folder;
  const std::string nrrd =
      "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 3 4\nencoding: raw\n\n" + ramp(24, 7);
  const Scan scan = readScan(folder.write("a.raw", nrrd), told({4, 3, 2}));
  EXPECT_EQ(scan.volume->geometry.dims, glm::ivec3(2, 3, 4));
  // Of another name, and of one that other programs use.
  EXPECT_EQ(readScan(folder.write("b.xyz", ramp(24)), told({4, 3, 2})).volume->geometry.dims,
            glm::ivec3(4, 3, 2));
  EXPECT_EQ(readScan(folder.write("b.vol", ramp(24)), told({4, 3, 2})).volume->geometry.dims,
            glm::ivec3(4, 3, 2));
}

// Whatever its name promises, and wherever it is looked at: listed, read, as a mask.
TEST(RawFile, IsWhatItIsToldEverywhere) {
  const TempFolder folder;
  const auto file = folder.write("a.vol", ramp(24));
  EXPECT_TRUE(listVolumes(file, told({4, 3, 2})).empty());
  EXPECT_EQ(readMarks(file, told({4, 3, 2}).raw).volume->geometry.dims, glm::ivec3(4, 3, 2));
  ReadOptions fifth = told({4, 3, 2});
  fifth.volume = 5;
  expectError([&] { readScan(file, fifth); }, "there is no volume 5");
  ReadOptions flat = told({4, 3, 2});
  flat.raw.spacing = {0.5, 0.5, 0};
  expectError([&] { readScan(file, flat); }, "give all three", Error::Kind::usage);
}

TEST(RawFile, MakesVoxelsOfASector) {
  const TempFolder folder;
  ReadOptions options = told({30, 20, 12});
  options.raw.grid = RawGrid::sector;
  const auto file = folder.write("a.raw", std::string(30 * 20 * 12, '\x80'));
  expectError([&] { readScan(file, options); }, "raw.fanAngle", Error::Kind::usage);
  options.raw.spacing = {1, 0, 0};
  options.raw.firstRadius = 30;
  options.raw.axisDepth = 10;
  options.raw.fanAngle = 60;
  options.raw.sweepAngle = 50;
  options.voxel = 1.5;
  const Scan scan = readScan(file, options);
  EXPECT_EQ(scan.volume->geometry.spacing, glm::dvec3(1.5));
  ASSERT_TRUE(scan.mask && scan.beam);
  EXPECT_EQ(scan.beam->apex, glm::dvec3(0));
  const Geometry& g = scan.volume->geometry;
  for (std::size_t v = 0; v < g.voxels(); ++v)
    ASSERT_NEAR(scan.volume->data[v], scan.mask->data[v] ? 128 / 255.0 : 0.0, 1e-6);
  const double radius = 0.5 * glm::length(g.spacing * glm::dvec3(g.dims));
  EXPECT_GT(radius, 25);
  options.voxel = 1e-9;
  expectError([&] { readScan(file, options); }, "larger scan.voxel", Error::Kind::system);
  options.raw.axisDepth = 29;
  expectError([&] { readScan(file, options); }, "turned about", Error::Kind::usage);
}

TEST(RawFile, MakesVoxelsOfAPyramid) {
  const TempFolder folder;
  ReadOptions options = told({20, 30, 6});
  options.raw.grid = RawGrid::pyramid;
  const auto file = folder.write("a.raw", std::string(20 * 30 * 6, '\x80'));
  expectError([&] { readScan(file, options); }, "raw.aperture", Error::Kind::usage);
  options.raw.spacing = {0.6, 0.6, 0};
  options.raw.aperture = 4;
  options.raw.sweepAngle = 30;
  const Scan scan = readScan(file, options);
  EXPECT_EQ(scan.volume->geometry.dims.x, 20);
  EXPECT_EQ(scan.volume->geometry.dims.y, 30);
  EXPECT_EQ(scan.volume->geometry.dims.z % 6, 0);
  EXPECT_NEAR(scan.volume->geometry.spacing.z * scan.volume->geometry.dims.z,
              4 + 2 * std::tan(glm::radians(15.0)) * 18, 1e-9);
}

}  // namespace
}  // namespace sonoskin
