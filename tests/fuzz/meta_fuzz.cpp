// MetaImage files: header, geometry and numbers.
#include "tests/fuzz/declared_volumes.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("a.mha");
  fuzz::attempt([&] { fuzz::readAndClaim(FileFormat::meta, file.hold({data, size})); });
  return 0;
}
