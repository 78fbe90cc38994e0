#include "core/io/dicom/dicom_patient.h"

#include <algorithm>

#include "core/base/error.h"

namespace sonoskin {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Text that a DICOM file may hold in one short line: letters of any script, no control characters, and no \, which parts
// values.
bool isLine(const std::string& text) {
  return text.size() <= 64 && std::ranges::none_of(text, [](char c) {
           return static_cast<unsigned char>(c) < ' ' || c == '\x7f' || c == '\\';
         });
}

bool isDate(const std::string& text) {
  if (text.size() != 8 || !std::ranges::all_of(text, isDigit)) return false;
  const int month = std::stoi(text.substr(4, 2)), day = std::stoi(text.substr(6));
  return month >= 1 && month <= 12 && day >= 1 && day <= 31;
}

}  // namespace

void requireSound(const DicomPatient& patient) {
  const auto refuse = [](const char* sentence) { throw Error(sentence, Error::Kind::usage); };
  if (!isLine(patient.name))
    refuse("A patient's name has at most 64 letters and no backslash; give it as in Doe^Jane.");
  if (!isLine(patient.id)) refuse("A patient's ID has at most 64 letters and no backslash; give another.");
  if (!patient.birthDate.empty() && !isDate(patient.birthDate))
    refuse("A patient's date of birth has eight digits, year first; give it as in 19900131.");
  if (!patient.sex.empty() && patient.sex != "M" && patient.sex != "F" && patient.sex != "O")
    refuse("A patient's sex is one letter; give M, F or O.");
}

}  // namespace sonoskin
