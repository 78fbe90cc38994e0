// GE Kretz files within files of DICOM, and what lies beside them.
#include <gtest/gtest.h>

#include "core/base/log.h"
#include "core/io/dicom/dicom_series.h"
#include "core/io/volume_loader.h"
#include "core/io/volume_reader.h"
#include "tests/support/dicom.h"
#include "tests/support/expect_error.h"
#include "tests/support/kretz.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::DicomImage;
using test::expectError;
using test::KretzWriter;
using test::TempFolder;

// Three frames 0.75 mm apart, and an element that holds `kretz`.
std::string kretzInDicom(const std::string& kretz) {
  DicomImage image;
  image.frames = 3, image.numbers.assign(4 * 3 * 3, 100);
  image.modality = "US", image.series = "1.2.3.4.6";
  image.others = {
      {0x18, 0x88, "DS", "0.75"}, {0x7FE1, 0x11, "LO", "KRETZ_US"}, {0x7FE1, 0x1101, "OB", kretz}};
  return dicomFile(image);
}
KretzWriter voxels() {
  return KretzWriter().dims(4, 3, 2).values(0x10, 0x22, {0.25}).record(0xD000, 1, test::ramp(24));
}
KretzWriter packed() { return KretzWriter().record(2, 0x1000, "xx"); }

struct Folder : TempFolder {
  Folder() {
    for (int k = 0; k < 5; ++k) {
      DicomImage image;
      image.number = k + 1, image.place = 2 * k, image.numbers.assign(4 * 3, 10 * k);
      write(std::to_string(k) + ".dcm", dicomFile(image));
    }
  }
};

// The pictures of the file are all that there is.
TEST(DicomKretz, AnEmptyOneIsNone) {
  const TempFolder folder;
  folder.write("k.dcm", kretzInDicom(""));
  const LogRecord record;
  const LoadedVolume v = loadVolume(folder / "k.dcm");
  EXPECT_EQ(v.stored.geometry.dims, glm::ivec3(4, 3, 3));
  EXPECT_EQ(v.stored.geometry.spacing.z, 0.75);
  ASSERT_EQ(record.sentences(LogLevel::warning).size(), 1u);
  EXPECT_NE(record.sentences(LogLevel::warning)[0].find("nothing is there"), std::string::npos);
}

TEST(DicomKretz, IsOneVolumeOfAFolder) {
  const Folder folder;
  folder.write("z.dcm", kretzInDicom(voxels().end().bytes()));
  EXPECT_EQ(entriesText(dicomVolumes(folder.path())), "1: 4 x 3 x 5, CT; 2: 4 x 3 x 2, US");
  const LoadedVolume v = loadVolume(folder.path(), {2});
  EXPECT_EQ(std::string(v.numbers.begin(), v.numbers.end()), test::ramp(24));
  EXPECT_EQ(v.stored.format, "GE Kretz in DICOM");
  EXPECT_EQ(v.stored.geometry.spacing, glm::dvec3(0.25));
}

TEST(DicomKretz, ThatNobodyReadsIsNoReasonToRefuseOthers) {
  for (const std::string& kretz : {packed().bytes(), voxels().bytes().substr(0, 60), std::string("other")}) {
    const Folder folder;
    folder.write("z.dcm", kretzInDicom(kretz));
    const LogRecord record;
    EXPECT_TRUE(dicomVolumes(folder.path()).empty());
    EXPECT_EQ(loadVolume(folder.path()).stored.geometry.dims, glm::ivec3(4, 3, 5));
    ASSERT_FALSE(record.sentences(LogLevel::warning).empty());
    EXPECT_NE(record.sentences(LogLevel::warning)[0].find("1 DICOM file is left out"), std::string::npos);
  }
  const TempFolder alone;
  alone.write("k.dcm", kretzInDicom(packed().bytes()));
  expectError([&] { readScan(alone / "k.dcm"); }, "packed by GE's wavelets");
  expectError([&] { readScan(alone.path()); }, "packed by GE's wavelets");
}

}  // namespace
}  // namespace sonoskin
