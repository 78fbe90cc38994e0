#include <gtest/gtest.h>

#include "core/io/scanners/voreen_dat.h"
#include "core/io/scanners/voreen_vvd.h"
#include "core/io/volume_reader.h"
#include "tests/support/expect_error.h"
#include "tests/support/kretz.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::ramp;
using test::TempFolder;

std::string text(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

std::string dat(const std::string& more) {
  return "ObjectFileName: a.raw\nTaggedFileName: ---\nResolution: 4 3 2\nSliceThickness: 0.5 1 2\n" + more;
}

TEST(VoreenDat, ReadsTheFileBesideIt) {
  const TempFolder folder;
  folder.write("a.raw", ramp(24));
  const LoadedVolume loaded =
      readVoreenDat(folder.write("a.dat", dat("Format: UCHAR\nObjectModel: I\nGridType: EQUIDISTANT\n")), {});
  EXPECT_EQ(text(loaded.numbers), ramp(24));
  EXPECT_EQ(loaded.stored.geometry.dims, glm::ivec3(4, 3, 2));
  EXPECT_EQ(loaded.stored.geometry.spacing, glm::dvec3(0.5, 1, 2));
  EXPECT_TRUE(loaded.stored.spacingKnown);
  EXPECT_EQ(readScan(folder / "a.dat").volume->geometry.dims, glm::ivec3(4, 3, 2));
}

TEST(VoreenDat, KnowsTypesColoursAndByteOrder) {
  const TempFolder folder;
  folder.write("a.raw", ramp(48));
  LoadedVolume loaded =
      readVoreenDat(folder.write("a.dat", dat("Format: USHORT\nByteOrder: big-endian\n")), {});
  EXPECT_EQ(loaded.stored.type, NumberType::uint16);
  EXPECT_EQ(loaded.numbers[0], 1);
  EXPECT_EQ(loaded.numbers[1], 0);
  folder.write("a.raw", ramp(72));
  loaded = readVoreenDat(folder.write("a.dat", dat("Format: UCHAR\nObjectModel: RGB\n")), {});
  EXPECT_EQ(loaded.stored.components, 3);
  // QVis writes RGBA whatever is in it.
  folder.write("a.raw", ramp(24));
  loaded = readVoreenDat(folder.write("a.dat", dat("Format: UCHAR\nObjectModel: RGBA\n")), {});
  EXPECT_EQ(loaded.stored.components, 1);
  folder.write("a.raw", ramp(72));
  ReadOptions second;
  second.time = 2;
  loaded = readVoreenDat(folder.write("a.dat", dat("Format: UCHAR\nNumFrames: 3\n")), second);
  EXPECT_EQ(loaded.stored.timeSteps, 3);
  EXPECT_EQ(text(loaded.numbers), ramp(24, 24));
}

TEST(VoreenDat, ReadsInviwosNameAndNoColourThatIsCutShort) {
  const TempFolder folder;
  folder.write("a.raw", ramp(24));
  const LoadedVolume loaded =
      readVoreenDat(folder.write("a.dat", "RawFile: a.raw\nResolution: 4 3 2\nFormat: UINT8\n"), {});
  EXPECT_EQ(text(loaded.numbers), ramp(24));
  folder.write("a.raw", ramp(60));
  EXPECT_THROW(readVoreenDat(folder.write("b.dat", dat("Format: UCHAR\nObjectModel: RGB\n")), {}), Error);
  EXPECT_THROW(readVoreenDat(folder.write("b.dat", dat("Format: UCHAR\nObjectModel: RGBA\n")), {}), Error);
}

TEST(VoreenDat, RefusesWhatItDoesNotKnow) {
  const TempFolder folder;
  folder.write("a.raw", ramp(24));
  const auto refuses = [&](const std::string& header, const std::string& part) {
    expectError([&] { readVoreenDat(folder.write("a.dat", header), {}); }, part);
  };
  refuses("nothing\n", "ObjectFileName");
  refuses(dat("Format: UCHAR128\n"), "Format");
  refuses(dat("Format: UCHAR\nObjectModel: LAB\n"), "ObjectModel");
  refuses(dat("Format: USHORT\n"), "has 24 bytes");
  refuses(dat("Format: UCHAR\nByteOrder: middle\n"), "byte order");
  refuses("ObjectFileName: ../a.raw\nResolution: 4 3 2\nFormat: UCHAR\n", "outside of its own folder");
  refuses("ObjectFileName: a.raw\nResolution: 4 3 nan\nFormat: UCHAR\n", "Resolution");
  refuses("ObjectFileName: a.raw\nResolution: 4 3 1\nFormat: UCHAR\n", "Resolution");
  refuses(dat("Format: UCHAR\nNumFrames: 0\n"), "NumFrames");
  refuses(std::string("ObjectFileName: a\x01.raw\nResolution: 4 3 2\nFormat: UCHAR\n"), "is not text");
  refuses("ObjectFileName: gone.raw\nResolution: 4 3 2\nFormat: UCHAR\n", "not beside it");
}

std::string vvd(const std::string& volume) {
  return "<?xml version=\"1.0\" ?><VoreenData version=\"1\"><Volumes>" + volume + "</Volumes></VoreenData>";
}
std::string volumeOf(const std::string& file, const std::string& meta) {
  return "<Volume><RawData filename=\"" + file + "\" format=\"uint8\" x=\"4\" y=\"3\" z=\"2\" /><MetaData>" +
         meta + "</MetaData></Volume>";
}
const std::string kPlace =
    "<MetaItem name=\"Offset\" type=\"Vec3MetaData\"><value x=\"1\" y=\"2\" z=\"3\" /></MetaItem>"
    "<MetaItem name=\"Spacing\" type=\"Vec3MetaData\"><value x=\"0.5\" y=\"1\" z=\"2\" /></MetaItem>";

TEST(VoreenVvd, ReadsTheFileBesideItAndItsPlace) {
  const TempFolder folder;
  folder.write("a.raw", ramp(24));
  LoadedVolume loaded = readVoreenVvd(folder.write("a.vvd", vvd(volumeOf("a.raw", kPlace))), {});
  EXPECT_EQ(text(loaded.numbers), ramp(24));
  EXPECT_EQ(loaded.stored.geometry.origin, glm::dvec3(1, 2, 3));
  EXPECT_EQ(loaded.stored.geometry.spacing, glm::dvec3(0.5, 1, 2));
  const std::string turn =
      "<MetaItem name=\"Transformation\" type=\"Mat4MetaData\"><value><row0 x=\"0\" y=\"-1\" z=\"0\" "
      "w=\"10\" />"
      "<row1 x=\"1\" y=\"0\" z=\"0\" w=\"0\" /><row2 x=\"0\" y=\"0\" z=\"1\" w=\"0\" />"
      "<row3 x=\"0\" y=\"0\" z=\"0\" w=\"1\" /></value></MetaItem>";
  loaded = readVoreenVvd(folder.write("a.vvd", vvd(volumeOf("a.raw", kPlace + turn))), {});
  EXPECT_LT(glm::distance(loaded.stored.geometry.toWorld({2, 0, 0}), glm::dvec3(8, 2, 3)), 1e-12);
  const std::string paths =
      "<Volume><RawData format=\"uint8\" x=\"4\" y=\"3\" z=\"2\"><Paths noPathSet=\"false\"><paths>"
      "<item value=\"a.raw\" /></paths></Paths></RawData></Volume>";
  loaded = readVoreenVvd(folder.write("a.vvd", vvd(paths)), {});
  EXPECT_EQ(text(loaded.numbers), ramp(24));
  EXPECT_FALSE(loaded.stored.spacingKnown);
}

TEST(VoreenVvd, ListsSeveralVolumes) {
  const TempFolder folder;
  folder.write("a.raw", ramp(24));
  folder.write("b.raw", ramp(24, 100));
  const auto file = folder.write("a.vvd", vvd(volumeOf("a.raw", kPlace) + volumeOf("b.raw", kPlace)));
  EXPECT_EQ(vvdVolumes(file).size(), 2u);
  expectError([&] { readVoreenVvd(file, {}); }, "holds 2 volumes");
  ReadOptions second;
  second.volume = 2;
  EXPECT_EQ(text(readVoreenVvd(file, second).numbers), ramp(24, 100));
  second.volume = 3;
  expectError([&] { readVoreenVvd(file, second); }, "no volume 3");
}

TEST(VoreenVvd, RefusesWhatItDoesNotKnow) {
  const TempFolder folder;
  folder.write("a.raw", ramp(24));
  const auto refuses = [&](const std::string& header, const std::string& part) {
    expectError([&] { readVoreenVvd(folder.write("a.vvd", header), {}); }, part);
  };
  refuses("<VoreenData>", "no header of Voreen");
  refuses("<Other><Volume/></Other>", "no header of Voreen");
  refuses(vvd(""), "names no raw file");
  refuses(vvd(volumeOf("../a.raw", kPlace)), "outside of its own folder");
  std::string other = vvd(volumeOf("a.raw", kPlace));
  other.replace(other.find("uint8"), 5, "uint9");
  refuses(other, "format that is not known");
  other = vvd(volumeOf("a.raw", kPlace));
  other.replace(other.find("x=\"4\""), 5, "x=\"a\"");
  refuses(other, "no header of Voreen");
  other = vvd(volumeOf("a&#10;b.raw", kPlace));
  refuses(other, "no header of Voreen");
  // Entities that grow without end are expat's to refuse.
  std::string bomb = "<?xml version=\"1.0\"?><!DOCTYPE v [<!ENTITY a \"aaaaaaaaaa\">";
  for (char c = 'b'; c <= 'j'; ++c) {
    bomb += std::string("<!ENTITY ") + c + " \"";
    for (int n = 0; n < 10; ++n) bomb += std::string("&") + char(c - 1) + ";";
    bomb += "\">";
  }
  refuses(bomb + "]><VoreenData>&j;</VoreenData>", "no header of Voreen");
}

}  // namespace
}  // namespace sonoskin
