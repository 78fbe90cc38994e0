// NRRD headers: the guard in front of ITK, and whether the file holds what it declares.
#include "core/io/declared_data.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("a.nrrd");
  fuzz::attempt([&] {
    const std::filesystem::path path = file.hold({data, size});
    checkData(nrrdData(path), path);
  });
  return 0;
}
