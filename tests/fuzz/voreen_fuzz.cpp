// Voreen's headers: text where the first byte is even, else XML.
#include "core/base/log.h"
#include "core/io/scanners/voreen_dat.h"
#include "core/io/scanners/voreen_vvd.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::TempFolder folder;
  static const std::filesystem::path raw = folder.write("a.raw", std::string(72, 'x'));
  setLogListener([](LogLevel, const std::string&) {});
  if (size == 0) return 0;
  fuzz::attempt([&] {
    const std::string_view text = fuzz::textOf({data + 1, size - 1});
    const LoadedVolume loaded = data[0] % 2 == 0 ? readVoreenDat(folder.write("a.dat", text), {})
                                                 : readVoreenVvd(folder.write("a.vvd", text), {});
    const StoredVolume& stored = loaded.stored;
    fuzz::claim(loaded.numbers.size() ==
                    stored.geometry.voxels() * std::size_t(stored.components) * numberTypeBytes(stored.type),
                "every voxel has its numbers");
  });
  return 0;
}
