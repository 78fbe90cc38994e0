// readScan and readVolumeInfo on recordings that cannot be part of the sources.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/base/log.h"
#include "core/io/volume_loader.h"
#include "core/io/volume_reader.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::expectError;

class SharedData : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(data_)) GTEST_SKIP() << "the recordings are not on this machine";
  }
  const std::filesystem::path data_ = SONOSKIN_SHARED_DATA;
};

int byteAt(const Scan& scan, int i, int j, int k) { return int(std::lround(255 * scan.volume->at(i, j, k))); }

TEST_F(SharedData, NrrdOfAFetus) {
  const Scan scan = readScan(data_ / "fetus/fetus_00.nrrd");
  const Geometry& g = scan.volume->geometry;
  EXPECT_EQ(g.dims, glm::ivec3(256, 256, 192));
  EXPECT_NEAR(g.spacing.z, 0.588719, 1e-12);
  EXPECT_EQ(scan.originalType, "uint8");
  EXPECT_TRUE(scan.spacingKnown);
  EXPECT_EQ(byteAt(scan, 150, 60, 96), 255);
  EXPECT_EQ(byteAt(scan, 180, 55, 110), 18);
}

TEST_F(SharedData, NrrdOfAPhantom) {
  const VolumeInfo info = readVolumeInfo(data_ / "us/ibis_brain_phantom/brain_phantom_0p25mm.nrrd");
  EXPECT_EQ(info.geometry.dims, glm::ivec3(278, 165, 227));
  EXPECT_EQ(info.geometry.spacing, glm::dvec3(0.25));
  EXPECT_EQ(info.bytes, 4461877u);
}

// The sweep itself is refused: tracked_pictures_test.cpp.
TEST_F(SharedData, AMetaImageMadeOfASweep) {
  const VolumeInfo volume =
      readVolumeInfo(data_ / "us/plus_bone/vtkVolumeReconstructorTestLNMEANvolumeRef.mha");
  EXPECT_EQ(volume.geometry.dims, glm::ivec3(80, 93, 98));
  EXPECT_EQ(volume.geometry.spacing, glm::dvec3(0.5));
}

TEST_F(SharedData, NiftiWithTime) {
  const VolumeInfo info = readVolumeInfo(data_ / "us/itksnap_echo/ultrasound_img4d.nii.gz");
  EXPECT_EQ(info.geometry.dims, glm::ivec3(56, 52, 56));
  EXPECT_NEAR(info.geometry.spacing.y, 3.7216, 1e-4);
  EXPECT_EQ(info.timeSteps, 3);
  EXPECT_EQ(info.numberType, "float32");
  EXPECT_EQ(readScan(data_ / "us/itksnap_echo/ultrasound_img4d.nii.gz").volume->data.size(), 56u * 52 * 56);
}

TEST_F(SharedData, DicomSeriesIsSortedByPosition) {
  const VolumeInfo info = readVolumeInfo(data_ / "ct/slicer_head");
  EXPECT_EQ(info.geometry.dims, glm::ivec3(64, 64, 93));
  EXPECT_NEAR(info.geometry.spacing.x, 3.2, 1e-9);
  EXPECT_NEAR(info.geometry.spacing.z, 1.5, 1e-6);
  EXPECT_TRUE(info.spacingKnown);
  EXPECT_EQ(info.valueMin, 0);
  EXPECT_EQ(info.valueMax, 3926);
  // Neighbouring slices of a head look alike only in the right order.
  const Scan scan = readScan(data_ / "ct/slicer_head/CTHead17.dcm");
  EXPECT_EQ(scan.volume->geometry.dims.z, 93);
  double difference = 0, spread = 0;
  for (int k = 1; k < 93; ++k)
    for (int j = 0; j < 64; ++j)
      for (int i = 0; i < 64; ++i) {
        difference += std::abs(double(scan.volume->at(i, j, k) - scan.volume->at(i, j, k - 1)));
        spread += std::abs(double(scan.volume->at(i, j, k) - scan.volume->at(i, j, 92 - k)));
      }
  EXPECT_LT(difference, 0.2 * spread);
}

// The same torus, whatever it lies in.
TEST_F(SharedData, KretzInDicomIsTheKretzFile) {
  const LoadedVolume plain = loadVolume(data_ / "kretz/brainphantom_toroidal.vol");
  const LoadedVolume inside = loadVolume(data_ / "kretz/brainphantom_kretz_in_dicom.dcm");
  EXPECT_EQ(inside.stored.geometry.dims, glm::ivec3(200, 96, 80));
  EXPECT_EQ(inside.stored.grid.has_value(), plain.stored.grid.has_value());
  EXPECT_EQ(inside.numbers, plain.numbers);
  EXPECT_EQ(readScan(data_ / "kretz/brainphantom_kretz_in_dicom.dcm").key,
            readScan(data_ / "kretz/brainphantom_toroidal.vol").key);
}

// The header calls millimetres centimetres: it is read as it says, with a word. The voxels are those of the NIfTI.
TEST_F(SharedData, PhilipsCartesianIsReadAsItSays) {
  const fs::path path = data_ / "us/itksnap_echo/echo_cartesian_philips_3frames_realvoxels.dcm";
  const LogRecord record;
  for (int t = 1; t <= 3; ++t) {
    const Scan scan = readScan(path, {0, t}),
               other = readScan(data_ / "us/itksnap_echo/ultrasound_img4d.nii.gz", {0, t});
    EXPECT_EQ(scan.volume->geometry.dims, glm::ivec3(56, 52, 56));
    EXPECT_NEAR(glm::length(scan.volume->geometry.spacing - 10.0 * other.volume->geometry.spacing), 0, 1e-3);
    double off = 0;
    for (std::size_t v = 0; v < scan.volume->data.size(); ++v)
      off = std::max(
          off, std::abs(255 * double(scan.volume->data[v]) -
                        std::round(double(other.volume->data[v]) * (other.originalMax - other.originalMin) +
                                   other.originalMin)));
    EXPECT_LE(off, 1.001) << t;
  }
  ASSERT_FALSE(record.sentences(LogLevel::warning).empty());
  EXPECT_NE(record.sentences(LogLevel::warning)[0].find("larger than any probe sees"), std::string::npos);
  expectError([&] { readScan(data_ / "us/itksnap_echo/echo_cartesian_dummy.dcm"); },
              "longer than what is left of it");
}

TEST_F(SharedData, NothingNamesThePatient) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string told;
  for (const char* name :
       {"ct/slicer_head", "kretz/brainphantom_kretz_in_dicom.dcm", "us/itksnap_echo/echo_cartesian_dummy.dcm",
        "us/plus_bone/BoneUltrasound_L14.igs.mha"}) {
    try {
      const VolumeInfo info = readVolumeInfo(data_ / name);
      told += info.format + info.numberType;
    } catch (const Error& error) {
      told += error.what();
    }
  }
  told += testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  for (const char* secret : {"Austrialian", "XXXX", "PHANTOM", "TEST0001", "20200101"})
    EXPECT_EQ(told.find(secret), std::string::npos) << told;
}

}  // namespace
}  // namespace sonoskin
