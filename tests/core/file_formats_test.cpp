#include "core/io/file_formats.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>

#include "core/io/image.h"
#include "core/io/mesh_reader.h"
#include "core/io/mesh_writer.h"
#include "core/io/textured_mesh_writer.h"
#include "core/io/volume_reader.h"
#include "core/io/volume_writer.h"
#include "tests/support/dicom.h"
#include "tests/support/expect_error.h"
#include "tests/support/kretz.h"
#include "tests/support/meshes.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::expectError;
using test::fileText;
using test::TempFolder;

Volume<std::uint8_t> bytes() {
  Volume<std::uint8_t> volume(test::grid({4, 3, 2}, {0.5, 0.5, 2}));
  for (std::size_t v = 0; v < volume.data.size(); ++v) volume.data[v] = std::uint8_t(10 * v + 5);
  return volume;
}

std::string unpacked(const fs::path& path) {
  std::string all(1 << 16, '\0');
  const gzFile file = gzopen(path.c_str(), "rb");
  all.resize(std::size_t(gzread(file, all.data(), unsigned(all.size()))));
  gzclose(file);
  return all;
}

bool isRaw(const std::string& ending) { return ending == ".raw" || ending == ".bin" || ending == ".img"; }
bool isKretz(const std::string& ending) { return ending == ".vol" || ending == ".v00" || ending == ".4dv"; }

// A file of the volume above under an ending that is read, whether or not it is written.
fs::path volumeFile(const TempFolder& folder, const std::string& ending) {
  const auto& written = extensionsOf(FileKind::writtenVolume);
  const fs::path path = folder / ("scan" + ending);
  const Volume<std::uint8_t> volume = bytes();
  if (std::ranges::count(written, ending) > 0) {
    writeVolume(path, volume);
    return path;
  }
  folder.write("scan.raw", std::string(volume.data.begin(), volume.data.end()));
  if (ending == ".nhdr")
    return folder.write("scan.nhdr",
                        "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 3 2\nspacings: 0.5 0.5 2\n"
                        "encoding: raw\ndata file: scan.raw\n");
  if (ending == ".mhd")
    return folder.write("scan.mhd",
                        "ObjectType = Image\nNDims = 3\nDimSize = 4 3 2\nElementSpacing = 0.5 0.5 2\n"
                        "ElementType = MET_UCHAR\nElementDataFile = scan.raw\n");
  if (ending == ".nii") {
    writeVolume(folder / "scan.nii.gz", volume);
    return folder.write("scan.nii", unpacked(folder / "scan.nii.gz"));
  }
  if (ending == ".hdr") {
    writeVolume(folder / "scan.nii.gz", volume);
    const std::string whole = unpacked(folder / "scan.nii.gz");
    folder.write("scan.img", whole.substr(352));
    std::string header = whole.substr(0, 348);
    header.replace(108, 4, 4, '\0');  // where the voxels begin
    header.replace(344, 3, "ni1");
    return folder.write("scan.hdr", header);
  }
  if (ending == ".dcm") {
    for (int s = 0; s < 2; ++s) {
      test::DicomImage slice;
      slice.allocated = slice.stored = 8;
      slice.numbers.assign(volume.data.begin() + 12 * s, volume.data.begin() + 12 * (s + 1));
      slice.number = s + 1, slice.place = 2.0 * s;
      folder.write("scan" + std::string(s, 'b') + ".dcm", test::dicomFile(slice));
    }
    return path;
  }
  const std::string numbers(volume.data.begin(), volume.data.end());
  if (ending == ".dat")
    return folder.write("scan.dat",
                        "ObjectFileName: scan.raw\nResolution: 4 3 2\nSliceThickness: 0.5 0.5 2\n"
                        "Format: UCHAR\n");
  if (ending == ".vvd")
    return folder.write(
        "scan.vvd",
        "<VoreenData><Volumes><Volume><RawData filename=\"scan.raw\" format=\"uint8\" x=\"4\" "
        "y=\"3\" z=\"2\"/><MetaData><MetaItem name=\"Spacing\" type=\"Vec3MetaData\">"
        "<value x=\"0.5\" y=\"0.5\" z=\"2\"/></MetaItem></MetaData></Volume></Volumes>"
        "</VoreenData>");
  if (isRaw(ending)) return folder.write("scan" + ending, numbers);
  if (isKretz(ending))
    return folder.write("scan" + ending, test::KretzWriter()
                                             .dims(4, 3, 2)
                                             .values(0xC100, 1, {0.0005})
                                             .record(0xD000, 1, numbers)
                                             .end()
                                             .bytes());
  ADD_FAILURE() << "no file is known for " << ending;
  return path;
}

TEST(FileFormats, EveryVolumeThatIsOfferedIsRead) {
  for (const std::string& ending : extensionsOf(FileKind::readVolume)) {
    SCOPED_TRACE(ending);
    const TempFolder folder;
    ReadOptions options;
    if (isRaw(ending)) options.raw.dims = {4, 3, 2};
    if (isRaw(ending)) options.raw.spacing = {0.5, 0.5, 2};
    const Scan scan = readScan(volumeFile(folder, ending), options);
    ASSERT_EQ(scan.volume->geometry.dims, glm::ivec3(4, 3, 2));
    // Kretz files have one spacing for all axes.
    EXPECT_EQ(scan.volume->geometry.spacing, glm::dvec3(0.5, 0.5, isKretz(ending) ? 0.5 : 2));
    for (std::size_t v = 0; v < 24; ++v) EXPECT_NEAR(scan.volume->data[v], float(10 * v + 5) / 255, 1e-6);
  }
}

TEST(FileFormats, EveryFileThatIsOfferedForWritingComesBack) {
  const TempFolder folder;
  const Mesh ball = test::icosphere(1, 10, {});
  for (const std::string& ending : extensionsOf(FileKind::writtenVolume)) {
    writeVolume(folder / ("v" + ending), bytes());
    EXPECT_EQ(readVolumeInfo(folder / ("v" + ending)).valueMax, 235) << ending;
  }
  for (const std::string& ending : extensionsOf(FileKind::writtenMesh)) {
    writeMesh(folder / ("m" + ending), ball);
    if (ending == ".dcm") continue;  // a volume's ending where it is read; see dicom_stl_test.cpp
    EXPECT_EQ(readMesh(folder / ("m" + ending)).triangles.size(), ball.triangles.size()) << ending;
  }
  writePng(folder / "p.png", {2, 1, std::vector<std::uint8_t>(8, 7)});
  EXPECT_EQ(readPng(folder / "p.png").rgba, std::vector<std::uint8_t>(8, 7));
  EXPECT_EQ(extensionsOf(FileKind::picture), std::vector<std::string>{".png"});
}

// What is made for printers and for pictures is written as what is a mesh, and read under the same endings.
TEST(FileFormats, KindsOfMeshesAgree) {
  const auto& read = extensionsOf(FileKind::readMesh);
  for (const FileKind kind : {FileKind::printedMesh, FileKind::texturedMesh}) {
    EXPECT_GE(extensionsOf(kind).size(), 2u);
    for (const std::string& ending : extensionsOf(kind)) EXPECT_EQ(std::ranges::count(read, ending), 1);
  }
}

// Every sentence about an ending that is none names all that are.
TEST(FileFormats, OtherEndingsAreRefusedWithThoseThatAre) {
  const TempFolder folder;
  const auto expectAll = [&](FileKind kind, Error::Kind error, const auto& call) {
    for (const std::string& ending : extensionsOf(kind)) expectError(call, ending, error);
  };
  const fs::path other = folder.write("a.xyz", "hello");
  expectAll(FileKind::readVolume, Error::Kind::input, [&] { readScan(other); });
  expectAll(FileKind::readMesh, Error::Kind::input, [&] { readMesh(other); });
  expectAll(FileKind::writtenVolume, Error::Kind::usage, [&] { writeVolume(other, bytes()); });
  expectAll(FileKind::writtenMesh, Error::Kind::usage, [&] { writeMesh(other, test::icosphere(0, 1, {})); });
  expectAll(FileKind::texturedMesh, Error::Kind::usage, [&] { writeTexturedMesh(other, {}); });
  expectAll(FileKind::picture, Error::Kind::usage, [&] { writePng(other, {}); });
  for (const FileKind kind : {FileKind::writtenVolume, FileKind::writtenMesh, FileKind::printedMesh,
                              FileKind::texturedMesh, FileKind::picture, FileKind::recipe, FileKind::text})
    expectAll(kind, Error::Kind::usage, [&] { requireFormat(kind, "face.vol"); });
  EXPECT_EQ(fileText(other), "hello");
}

TEST(FileFormats, SayWhatAFileIsInstead) {
  const TempFolder folder;
  writeMesh(folder / "a.ply", test::icosphere(0, 1, {}));
  expectError([&] { readScan(folder / "a.ply"); }, "is a mesh, not a volume");
  writeVolume(folder / "a.nrrd", bytes());
  expectError([&] { readMesh(folder / "a.nrrd"); }, "is a volume, not a mesh");
  fs::rename(folder / "a.ply", folder / "b.nrrd");
  expectError([&] { readScan(folder / "b.nrrd"); }, "does not begin as NRRD files do");
}

// What a name without an ending becomes, and what is proposed.
TEST(FileFormats, TheUsualOneComesFirst) {
  EXPECT_EQ(extensionsOf(FileKind::writtenVolume).front(), ".nrrd");
  EXPECT_EQ(extensionsOf(FileKind::writtenMesh).front(), ".ply");
  EXPECT_EQ(extensionsOf(FileKind::printedMesh).front(), ".stl");
  EXPECT_EQ(extensionsOf(FileKind::texturedMesh).front(), ".glb");
  for (const FileKind kind : {FileKind::readVolume, FileKind::readMesh})
    for (const std::string& ending : extensionsOf(kind)) {
      const FileFormat format = *formatNamed(kind, "a" + ending);
      EXPECT_NE(formatList(kind).find(formatName(format)), std::string::npos) << ending;
    }
  EXPECT_EQ(formatName(FileFormat::glb), "GLB");
  EXPECT_EQ(formatName(FileFormat::json), "JSON");
}

// The first bytes count more than the name.
TEST(FileFormats, AreKnownByTheirMarks) {
  const TempFolder folder;
  writeVolume(folder / "a.nrrd", bytes());
  fs::rename(folder / "a.nrrd", folder / "a.dat");
  EXPECT_EQ(readVolumeInfo(folder / "a.dat").format, "NRRD");
}

TEST(FileFormats, NamesInCapitalsCountAndEndingsAloneDoNot) {
  EXPECT_EQ(formatNamed(FileKind::readVolume, "A.NII.GZ"), FileFormat::nifti);
  EXPECT_EQ(formatNamed(FileKind::readVolume, "/x/.nrrd"), std::nullopt);
  EXPECT_EQ(formatNamed(FileKind::readMesh, "nrrd"), std::nullopt);
}

}  // namespace
}  // namespace sonoskin
