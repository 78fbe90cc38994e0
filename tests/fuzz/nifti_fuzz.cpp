// NIfTI files, packed or not: header, geometry and numbers.
#include "tests/fuzz/declared_volumes.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("a.nii");
  fuzz::attempt([&] { fuzz::readAndClaim(FileFormat::nifti, file.hold({data, size})); });
  return 0;
}
