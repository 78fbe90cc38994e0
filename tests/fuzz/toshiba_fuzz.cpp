// The text beside Toshiba's raw files.
#include "core/base/log.h"
#include "core/io/scanners/toshiba_file.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::TempFolder folder;
  static const std::filesystem::path samples = folder.write("RawData_Vol1.bin", std::string(24, 'x'));
  setLogListener([](LogLevel, const std::string&) {});
  fuzz::attempt([&] {
    folder.write("PatientInfo.txt", fuzz::textOf({data, size}));
    const LoadedVolume loaded = readToshiba(samples, {});
    fuzz::claim(loaded.stored.grid && !gridFault(*loaded.stored.grid), "a grid that is accepted can be one");
  });
  return 0;
}
