// DICOM elements: the walk over their lengths in front of GDCM.
#include "core/io/dicom_lengths.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("a.dcm");
  fuzz::attempt([&] { checkDicomLengths(file.hold({data, size})); });
  return 0;
}
