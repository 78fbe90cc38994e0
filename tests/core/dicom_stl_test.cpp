// DICOM Encapsulated STL, read back by DCMTK, of which the writer knows nothing.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <set>

#include "core/io/mesh_encoders.h"
#include "core/io/mesh_writer.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::icosphere;
using test::TempFolder;

struct DicomStl : testing::Test {
  const TempFolder folder;
  const Mesh mesh = icosphere(2, 40, {1, 2, 3});
  DcmFileFormat file;

  DcmDataset& written(const DicomPatient& patient = {}) {
    writeMesh(folder / "a.dcm", mesh, MeshFileOptions{patient});
    EXPECT_TRUE(file.loadFile((folder / "a.dcm").c_str()).good());
    file.loadAllDataIntoMemory();
    return *file.getDataset();
  }
  static std::string text(DcmItem& item, std::uint16_t group, std::uint16_t element) {
    OFString value;
    EXPECT_TRUE(item.tagExists(DcmTagKey(group, element))) << std::hex << group << ',' << element;
    item.findAndGetOFStringArray(DcmTagKey(group, element), value);
    return value.c_str();
  }
};

TEST_F(DicomStl, HoldsTheFileItsUnitAndItsKind) {
  DcmDataset& data = written();
  const Uint8* document = nullptr;
  unsigned long bytes = 0;
  ASSERT_TRUE(data.findAndGetUint8Array(DCM_EncapsulatedDocument, document, &bytes).good());
  EXPECT_EQ(Bytes(document, document + bytes), encodeStl(mesh));
  EXPECT_EQ(bytes, 84 + 50 * mesh.triangles.size());
  EXPECT_EQ(text(data, 0x0008, 0x0016), UID_EncapsulatedSTLStorage);
  EXPECT_EQ(text(data, 0x0042, 0x0012), "model/stl");
  EXPECT_EQ(text(data, 0x0042, 0x0015), std::to_string(bytes));
  EXPECT_EQ(text(data, 0x0008, 0x0060), "M3D");
  DcmItem* unit = nullptr;
  ASSERT_TRUE(data.findAndGetSequenceItem(DcmTagKey(0x0040, 0x08EA), unit).good());
  EXPECT_EQ(text(*unit, 0x0008, 0x0100), "mm");
  EXPECT_EQ(text(*unit, 0x0008, 0x0102), "UCUM");
  OFString syntax;
  file.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, syntax);
  EXPECT_EQ(syntax, UID_LittleEndianExplicitTransferSyntax);
}

// Those that the standard wants of every such file (type 1), with a value, and those that may be empty (type 2).
// [DICOM PS3.3, A.85.1]
TEST_F(DicomStl, EveryAttributeOfTypeOneAndTwoIsThere) {
  DcmDataset& data = written();
  for (const DcmTagKey& tag :
       {DCM_SOPClassUID, DCM_SOPInstanceUID, DCM_StudyInstanceUID, DCM_SeriesInstanceUID,
        DCM_FrameOfReferenceUID, DCM_Modality, DCM_SeriesNumber, DCM_InstanceNumber, DCM_Manufacturer,
        DCM_ManufacturerModelName, DCM_DeviceSerialNumber, DCM_SoftwareVersions, DCM_BurnedInAnnotation,
        DCM_MIMETypeOfEncapsulatedDocument, DCM_EncapsulatedDocument, DcmTagKey(0x0040, 0x08EA)})
    EXPECT_TRUE(data.tagExistsWithValue(tag)) << tag.toString();
  for (const DcmTagKey& tag :
       {DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_PatientSex, DCM_StudyDate, DCM_StudyTime,
        DCM_StudyID, DCM_AccessionNumber, DCM_ReferringPhysicianName, DCM_PositionReferenceIndicator,
        DCM_ContentDate, DCM_ContentTime, DCM_AcquisitionDateTime, DCM_ConceptNameCodeSequence,
        DCM_DocumentTitle})
    EXPECT_TRUE(data.tagExists(tag)) << tag.toString();
}

TEST_F(DicomStl, IsNobodysUnlessAPatientIsGiven) {
  DcmDataset& nobody = written();
  for (const DcmTagKey& tag : {DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_PatientSex,
                               DCM_StudyDate, DCM_ContentDate, DCM_AccessionNumber})
    EXPECT_FALSE(nobody.tagExistsWithValue(tag)) << tag.toString();
  EXPECT_EQ(text(nobody, 0x0012, 0x0062), "YES");
  DcmDataset& given = written({"Featherstone^Wilhelmina", "4711", "19900131", "F"});
  EXPECT_EQ(text(given, 0x0010, 0x0010), "Featherstone^Wilhelmina");
  EXPECT_EQ(text(given, 0x0010, 0x0020), "4711");
  EXPECT_EQ(text(given, 0x0010, 0x0030), "19900131");
  EXPECT_EQ(text(given, 0x0010, 0x0040), "F");
  EXPECT_FALSE(given.tagExists(DcmTagKey(0x0012, 0x0062)));
}

TEST_F(DicomStl, UidsAreDecimalUuidsAndNeverTheSame) {
  std::set<std::string> uids;
  for (int n = 0; n < 20; ++n) {
    DcmDataset& data = written();
    for (const auto& [group, element] :
         {std::pair{0x0008, 0x0018}, {0x0020, 0x000D}, {0x0020, 0x000E}, {0x0020, 0x0052}}) {
      const std::string uid = text(data, std::uint16_t(group), std::uint16_t(element));
      EXPECT_TRUE(uid.starts_with("2.25.")) << uid;
      EXPECT_LE(uid.size(), 44u) << uid;
      EXPECT_TRUE(uid.size() > 6 && uid[5] != '0') << uid;
      EXPECT_TRUE(uids.insert(uid).second) << uid;
    }
  }
}

TEST_F(DicomStl, RefusesAPatientThatDicomDoesNotAllow) {
  for (const DicomPatient& patient :
       {DicomPatient{std::string(65, 'a'), "", "", ""}, DicomPatient{"a\\b", "", "", ""},
        DicomPatient{"", "a\nb", "", ""}, DicomPatient{"", "", "31.01.1990", ""},
        DicomPatient{"", "", "19901301", ""}, DicomPatient{"", "", "", "X"}})
    expectError([&] { writeMesh(folder / "b.dcm", mesh, MeshFileOptions{patient}); }, "A patient's",
                Error::Kind::usage);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.dcm"));
}

}  // namespace
}  // namespace sonoskin
