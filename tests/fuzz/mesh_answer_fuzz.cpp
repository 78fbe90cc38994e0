// What a process that reads meshes answers, were it led astray by its file.
#include "core/io/reader_wire.h"
#include "tests/fuzz/mesh_claims.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::attempt([&] { fuzz::claimSound(meshFrom({data, size}, "a.stl")); });
  return 0;
}
