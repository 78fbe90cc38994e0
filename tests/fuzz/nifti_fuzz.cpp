// NIfTI headers, packed and plain: the guard in front of ITK, and whether the file holds what it declares.
#include "core/io/declared_data.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile plain("a.nii"), packed("a.nii.gz");
  for (const fuzz::InputFile* file : {&plain, &packed})
    fuzz::attempt([&] {
      const std::filesystem::path path = file->hold({data, size});
      checkData(niftiData(path), path);
    });
  return 0;
}
