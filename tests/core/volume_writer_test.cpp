#include "core/io/volume_writer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/io/volume_reader.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"
#include "tests/support/volumes.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::filledVolume;
using test::geometryDistance;
using test::TempFolder;
using test::turnedGeometry;

// Both ways are ITK's: what is tested here is that nothing gets lost between its world and ours. Files that it has not
// written are in volume_reader_test.cpp.
class VolumeFormat : public testing::TestWithParam<const char*> {
 protected:
  Geometry geometry(bool mirrored) const {
    Geometry g = turnedGeometry(mirrored);
    if (std::string(GetParam()) == ".vtk") g.direction = glm::dmat3(1);
    return g;
  }
  // NIfTI stores its geometry as float.
  double tolerance() const { return std::string(GetParam()) == ".nii.gz" ? 2e-5 : 1e-9; }
  std::string name() const { return std::string("volume") + GetParam(); }
};

TEST_P(VolumeFormat, KeepsBytesAndGeometry) {
  for (const bool mirrored : {false, true}) {
    const TempFolder folder;
    const auto volume = filledVolume<std::uint8_t>(geometry(mirrored));
    writeVolume(folder / name(), volume);
    EXPECT_EQ(folder.entries(), 1);
    const Scan scan = readScan(folder / name());
    EXPECT_LT(geometryDistance(scan.volume->geometry, volume.geometry), tolerance());
    EXPECT_EQ(scan.volume->geometry.mirrors(), volume.geometry.mirrors());
    EXPECT_EQ(scan.originalType, "uint8");
    EXPECT_EQ(scan.originalMax, 255);
    EXPECT_TRUE(scan.spacingKnown);
    for (std::size_t v = 0; v < volume.data.size(); ++v)
      ASSERT_EQ(std::lround(255 * scan.volume->data[v]), volume.data[v]) << v;
  }
}

TEST_P(VolumeFormat, KeepsFloats) {
  const TempFolder folder;
  auto volume = filledVolume<float>(geometry(false));
  for (float& v : volume.data) v = 0.25f + 0.5f * v;
  writeVolume(folder / name(), volume);
  const Scan scan = readScan(folder / name());
  EXPECT_EQ(scan.originalType, "float32");
  for (std::size_t v = 0; v < volume.data.size(); ++v)
    ASSERT_NEAR(scan.volume->data[v], volume.data[v], 1e-6) << v;
}

INSTANTIATE_TEST_SUITE_P(All, VolumeFormat, testing::Values(".nrrd", ".mha", ".nii.gz", ".vtk"));

TEST(WriteVolume, KeepsTheBeam) {
  const auto volume = filledVolume<float>(turnedGeometry());
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, 3)), up = glm::normalize(glm::dvec3(-2, 1, 0));
  const Beam sector{glm::dvec3(1.5, -2.25, 0.1), axis, up};
  const Beam parallel{{}, {0, 0, -1}};
  for (const char* name : {"a.nrrd", "a.mha"}) {
    const TempFolder folder;
    writeVolume(folder / name, volume, sector);
    Scan scan = readScan(folder / name);
    ASSERT_TRUE(scan.beam && scan.beam->apex);
    EXPECT_LT(glm::distance(*scan.beam->apex, *sector.apex), 1e-12);
    EXPECT_LT(glm::distance(scan.beam->axis, sector.axis), 1e-12);
    EXPECT_LT(glm::distance(scan.beam->up, sector.up), 1e-12);
    writeVolume(folder / name, volume, parallel);
    scan = readScan(folder / name);
    ASSERT_TRUE(scan.beam && !scan.beam->apex);
    EXPECT_EQ(scan.beam->axis, parallel.axis);
    writeVolume(folder / name, volume);
    EXPECT_FALSE(readScan(folder / name).beam);
  }
}

TEST(WriteScan, WritesBytesWhereBytesWereRead) {
  const TempFolder folder;
  writeVolume(folder / "a.nrrd", filledVolume<std::uint8_t>(turnedGeometry()));
  const Scan scan = readScan(folder / "a.nrrd");
  writeScan(folder / "b.nrrd", scan);
  const Scan again = readScan(folder / "b.nrrd");
  EXPECT_EQ(again.originalType, "uint8");
  EXPECT_EQ(again.volume->data, scan.volume->data);
}

TEST(WriteVolume, RefusesWhatItCannotWrite) {
  const TempFolder folder;
  const auto volume = filledVolume<float>(turnedGeometry());
  expectError([&] { writeVolume(folder / "a.xyz", volume); }, ".nrrd, .mha, .nii.gz or .vtk",
              Error::Kind::usage);
  expectError([&] { writeVolume(folder / "a.vtk", volume); }, "direction", Error::Kind::usage);
  expectError([&] { writeVolume(folder / "a.nrrd", Volume<float>{}); }, "no volume");
  expectError([&] { writeVolume(folder / "no/a.nrrd", volume); }, "does not exist", Error::Kind::system);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteVolume, LeavesNothingWhenCancelled) {
  const TempFolder folder;
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(writeVolume(folder / "a.nrrd", filledVolume<float>(turnedGeometry()), {}, Progress(sink)),
               Cancelled);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace sonoskin
