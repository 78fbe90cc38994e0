// A folder of DICOM files: series, volumes, time steps, and the list of a DICOMDIR. The input is files one after another, each
// as two bytes of its length and what follows its preamble; an odd length makes it the DICOMDIR.
#include "core/base/log.h"
#include "tests/fuzz/dicom_claims.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int kMost = 12;
  setLogListener([](LogLevel, const std::string&) {});
  const test::TempFolder folder;
  fuzz::Bytes rest(data, size);
  for (int f = 0; f < kMost && rest.size() >= 2; ++f) {
    const std::size_t told = rest[0] | std::size_t(rest[1]) << 8, bytes = std::min(told / 2, rest.size() - 2);
    const std::string name = told % 2 == 1 ? "DICOMDIR" : std::to_string(f);
    folder.write(name, std::string(128, '\0') + "DICM" + std::string(fuzz::textOf(rest.subspan(2, bytes))));
    rest = rest.subspan(2 + bytes);
  }
  fuzz::attempt([&] { fuzz::readDicom(folder.path()); });
  return 0;
}
