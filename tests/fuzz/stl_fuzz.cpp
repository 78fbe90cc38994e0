// STL files, text and binary, as the program reads them.
#include "core/io/mesh_loader.h"
#include "tests/fuzz/mesh_claims.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("a.stl");
  fuzz::attempt([&] { fuzz::claimSound(parseMesh(file.hold({data, size}))); });
  return 0;
}
