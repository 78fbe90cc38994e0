#include "core/io/scanners/toshiba_file.h"

#include <gtest/gtest.h>

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

std::string info(const std::string& probe) {
  return "[Geometry Data]\r\nRange = 4\r\nAzimuth = 3\r\nElevation = 2\r\nRoiAxialSpanMm = 6\r\n"
         "AxialRoiStartMm = 50\r\nMechRadiusMm = 20\r\nApexAngleAzimuthHalf = 30\r\n"
         "ApexAngleElevationHalf = 40\r\nPatient Name = PLANTED^NAME\r\n" +
         probe;
}
std::string text(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

TEST(ToshibaFile, MakesAFanOfAConvexProbe) {
  const TempFolder folder;
  const auto file = folder.write("RawData_Vol1.bin", ramp(24));
  EXPECT_FALSE(isToshiba(file));
  folder.write("PatientInfo.txt", info("Probe Type = Convex\r\n"));
  EXPECT_TRUE(isToshiba(file));
  LogRecord record;
  const LoadedVolume loaded = readToshiba(file, {});
  EXPECT_EQ(text(loaded.numbers), ramp(24));
  const auto& grid = std::get<SweptGrid>(*loaded.stored.grid);
  EXPECT_FALSE(grid.parallel);
  EXPECT_DOUBLE_EQ(grid.sampleDistance, 2);
  EXPECT_DOUBLE_EQ(grid.firstRadius, 50);
  EXPECT_DOUBLE_EQ(grid.axisDepth, 30);
  EXPECT_NEAR(grid.fan[2], glm::radians(30.0), 1e-12);
  EXPECT_NEAR(grid.sweep[1], glm::radians(20.0), 1e-12);
  const auto said = record.sentences(LogLevel::warning);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("not certain"), std::string::npos);
  EXPECT_EQ(said[0].find("PLANTED"), std::string::npos);
}

TEST(ToshibaFile, MakesParallelBeamsOfALinearProbe) {
  const TempFolder folder;
  folder.write("RawData_Vol1.bin", ramp(24));
  std::string linear = info("Probe Type = Linear \r\n");
  linear.replace(linear.find("MechRadiusMm = 20"), 17, "MechRadiusMm = 130");
  folder.write("PatientInfo.txt", linear);
  const LoadedVolume loaded = readToshiba(folder / "RawData_Vol1.bin", {});
  const auto& grid = std::get<SweptGrid>(*loaded.stored.grid);
  EXPECT_TRUE(grid.parallel);
  EXPECT_DOUBLE_EQ(grid.axisDepth, -80);
  EXPECT_DOUBLE_EQ(grid.fan[0], -30);
}

TEST(ToshibaFile, TakesAFolderForARecordingInTime) {
  const TempFolder folder;
  folder.write("PatientInfo.txt", info("Probe Type = Convex\r\n"));
  for (const int step : {2, 10, 1})
    folder.write("RawData_Vol" + std::to_string(step) + ".bin", ramp(24, step));
  for (const auto& path : {folder.path(), folder / "PatientInfo.txt"}) {
    ReadOptions options;
    options.time = 3;
    const LoadedVolume loaded = readToshiba(path, options);
    EXPECT_EQ(loaded.stored.timeSteps, 3);
    EXPECT_EQ(text(loaded.numbers), ramp(24, 10));
  }
  EXPECT_EQ(readToshiba(folder / "RawData_Vol2.bin", {}).stored.timeSteps, 1);
  EXPECT_EQ(readScan(folder.path()).timeSteps, 3);
}

TEST(ToshibaFile, RefusesWhatCannotBe) {
  const TempFolder folder;
  const auto file = folder.write("RawData_Vol1.bin", ramp(23));
  folder.write("PatientInfo.txt", info(""));
  expectError([&] { readToshiba(file, {}); }, "has 23 bytes");
  folder.write("PatientInfo.txt", "Range = 4\n");
  expectError([&] { readToshiba(file, {}); }, "gives no number for RoiAxialSpanMm");
  std::string turned = info("");
  turned.replace(turned.find("Azimuth = 3"), 11, "Azimuth = 1");
  folder.write("PatientInfo.txt", turned);
  expectError([&] { readToshiba(file, {}); }, "whole number of 2 or more");
}

}  // namespace
}  // namespace sonoskin
