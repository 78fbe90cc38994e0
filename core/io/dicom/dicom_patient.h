#pragma once

#include <string>

namespace sonoskin {

// DicomPatient: whom a DICOM file that we write is about. All empty: nobody, which is what a file without a given patient
// says.
//   name       parts with ^ between them, such as "Doe^Jane"; 64 letters at most
//   id         64 letters at most
//   birthDate  eight digits, year first
//   sex        M, F or O
struct DicomPatient {
  std::string name, id, birthDate, sex;

  bool isGiven() const { return !name.empty() || !id.empty() || !birthDate.empty() || !sex.empty(); }
};

// requireSound: refuses what the standard does not allow in these places. [DICOM PS3.5, section 6.2]
//   errors  Error (usage): it is one of these; the sentence says which
void requireSound(const DicomPatient& patient);

}  // namespace sonoskin
