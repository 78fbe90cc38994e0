// NRRD files: header, geometry and numbers.
#include "tests/fuzz/declared_volumes.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("a.nrrd");
  fuzz::attempt([&] { fuzz::readAndClaim(FileFormat::nrrd, file.hold({data, size})); });
  return 0;
}
