#include <gdcmSequenceOfItems.h>
#include <gdcmTrace.h>
#include <gdcmWriter.h>

#include <array>
#include <random>
#include <sstream>

#include "core/base/error.h"
#include "core/base/version.h"
#include "core/io/mesh_encoders.h"

namespace sonoskin {
namespace {

using gdcm::Tag;
using gdcm::VR;

// A UID that no other file has: a random UUID as a decimal number. [DICOM PS3.5, B.2; RFC 4122, 4.4]
std::string newUid() {
  std::random_device random;
  std::array<std::uint32_t, 4> words{random(), random(), random(), random()};
  words[1] = (words[1] & 0xFFFF0FFF) | 0x4000;
  words[2] = (words[2] & 0x3FFFFFFF) | 0x80000000;
  std::string digits;
  while (words != std::array<std::uint32_t, 4>{}) {
    std::uint64_t rest = 0;
    for (std::uint32_t& word : words) {
      rest = rest << 32 | word;
      word = std::uint32_t(rest / 10);
      rest %= 10;
    }
    digits.insert(digits.begin(), char('0' + rest));
  }
  return "2.25." + digits;
}

template <class T>
void setBytes(gdcm::DataSet& to, Tag tag, VR type, const std::vector<T>& bytes) {
  gdcm::DataElement element(tag);
  element.SetVR(type);
  element.SetByteValue(reinterpret_cast<const char*>(bytes.data()), std::uint32_t(bytes.size() * sizeof(T)));
  to.Replace(element);
}

// Text of an even number of bytes, with the blank that its kind wants. [DICOM PS3.5, 6.2]
void set(gdcm::DataSet& to, Tag tag, VR type, std::string text) {
  if (text.size() % 2) text += type == VR::UI ? '\0' : ' ';
  setBytes(to, tag, type, std::vector<char>(text.begin(), text.end()));
}

void setSequence(gdcm::DataSet& to, Tag tag, const gdcm::DataSet* item) {
  gdcm::SmartPointer<gdcm::SequenceOfItems> sequence = new gdcm::SequenceOfItems;
  sequence->SetLengthToUndefined();
  if (item) {
    gdcm::Item only;
    only.SetVLToUndefined();
    only.SetNestedDataSet(*item);
    sequence->AddItem(only);
  }
  gdcm::DataElement element(tag);
  element.SetVR(VR::SQ);
  element.SetValue(*sequence);
  element.SetVLToUndefined();
  to.Replace(element);
}

// Patient, general study and series. Dates and times would tell which examination it was: they are left empty, as the
// standard allows. [DICOM PS3.3, C.7.1.1, C.7.2.1, C.24.1]
void setWhose(gdcm::DataSet& to, const DicomPatient& patient) {
  set(to, Tag(0x0010, 0x0010), VR::PN, patient.name);
  set(to, Tag(0x0010, 0x0020), VR::LO, patient.id);
  set(to, Tag(0x0010, 0x0030), VR::DA, patient.birthDate);
  set(to, Tag(0x0010, 0x0040), VR::CS, patient.sex);
  if (!patient.isGiven()) {
    set(to, Tag(0x0012, 0x0062), VR::CS, "YES");  // identity removed
    set(to, Tag(0x0012, 0x0063), VR::LO, "Nothing of the scan but its shape");
  }
  set(to, Tag(0x0020, 0x000D), VR::UI, newUid());
  set(to, Tag(0x0020, 0x000E), VR::UI, newUid());
  for (const Tag& date : {Tag(0x0008, 0x0020), Tag(0x0008, 0x0023)}) set(to, date, VR::DA, "");
  for (const Tag& time : {Tag(0x0008, 0x0030), Tag(0x0008, 0x0033)}) set(to, time, VR::TM, "");
  set(to, Tag(0x0008, 0x002A), VR::DT, "");
  set(to, Tag(0x0008, 0x0050), VR::SH, "");
  set(to, Tag(0x0008, 0x0090), VR::PN, "");
  set(to, Tag(0x0020, 0x0010), VR::SH, "");
  set(to, Tag(0x0020, 0x0011), VR::IS, "1");
  set(to, Tag(0x0020, 0x0013), VR::IS, "1");
}

// General and enhanced equipment, frame of reference. [DICOM PS3.3, C.7.5.2, C.7.4.1]
void setOrigin(gdcm::DataSet& to) {
  set(to, Tag(0x0008, 0x0060), VR::CS, "M3D");
  set(to, Tag(0x0008, 0x0070), VR::LO, "Sonoskin");
  set(to, Tag(0x0008, 0x1090), VR::LO, "Sonoskin");
  set(to, Tag(0x0018, 0x1000), VR::LO, "none");
  set(to, Tag(0x0018, 0x1020), VR::LO, kVersion);
  set(to, Tag(0x0020, 0x0052), VR::UI, newUid());
  set(to, Tag(0x0020, 0x1040), VR::LO, "");
}

// The document, its unit, and what can be seen of it: a face. [DICOM PS3.3, C.24.2, C.35.1]
void setDocument(gdcm::DataSet& to, const Bytes& stl) {
  set(to, Tag(0x0028, 0x0301), VR::CS, "NO");
  set(to, Tag(0x0028, 0x0302), VR::CS, "YES");
  gdcm::DataSet unit;
  set(unit, Tag(0x0008, 0x0100), VR::SH, "mm");
  set(unit, Tag(0x0008, 0x0102), VR::SH, "UCUM");
  set(unit, Tag(0x0008, 0x0104), VR::LO, "mm");
  setSequence(to, Tag(0x0040, 0x08EA), &unit);
  setSequence(to, Tag(0x0040, 0xA043), nullptr);
  set(to, Tag(0x0042, 0x0010), VR::ST, "Surface from ultrasound");
  setBytes(to, Tag(0x0042, 0x0011), VR::OB, stl);
  set(to, Tag(0x0042, 0x0012), VR::LO, "model/stl");
  setBytes(to, Tag(0x0042, 0x0015), VR::UL, std::vector<std::uint32_t>{std::uint32_t(stl.size())});
}

}  // namespace

Bytes encodeDicomStl(const Mesh& mesh, const DicomPatient& patient) {
  constexpr std::size_t kMost = 0xFFFFFF00;
  require(84 + 50 * mesh.triangles.size() < kMost,
          "The surface is too large for a DICOM file; write PLY instead.");
  requireSound(patient);
  gdcm::Trace::WarningOff();
  gdcm::Writer writer;
  gdcm::DataSet& data = writer.GetFile().GetDataSet();
  set(data, Tag(0x0008, 0x0005), VR::CS, "ISO_IR 192");
  set(data, Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.104.3");
  set(data, Tag(0x0008, 0x0018), VR::UI, newUid());
  setWhose(data, patient);
  setOrigin(data);
  setDocument(data, encodeStl(mesh));
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  std::ostringstream stream;
  writer.SetStream(stream);
  require(writer.Write(), "The surface cannot be written as DICOM; write STL instead.");
  const std::string bytes = std::move(stream).str();
  return {bytes.begin(), bytes.end()};
}

}  // namespace sonoskin
