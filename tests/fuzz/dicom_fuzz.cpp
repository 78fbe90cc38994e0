// DICOM in one file: elements, frames, places, pixels; GDCM's codecs are left out.
#include "core/base/log.h"
#include "tests/fuzz/dicom_claims.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("a.dcm");
  setLogListener([](LogLevel, const std::string&) {});
  fuzz::attempt([&] { fuzz::readDicom(file.hold({data, size})); });
  return 0;
}
