// GE Kretz files, as they lie in memory, on disk or inside of a DICOM file.
#include "core/base/log.h"
#include "core/io/scanners/kretz_file.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  setLogListener([](LogLevel, const std::string&) {});
  fuzz::attempt([&] {
    const std::vector<VolumeEntry> entries = kretzVolumes({data, size}, "a.vol");
    for (int volume = 0; volume <= int(entries.size()); ++volume) {
      ReadOptions options;
      options.volume = volume;
      const LoadedVolume loaded = kretzVolume({data, size}, options, "a.vol");
      const StoredVolume& stored = loaded.stored;
      fuzz::claim(loaded.numbers.size() == stored.geometry.voxels() * numberTypeBytes(stored.type),
                  "every voxel has its number");
      fuzz::claim(!stored.grid || gridDims(*stored.grid) == stored.geometry.dims,
                  "every sample has its place");
      fuzz::claim(!stored.grid || !gridFault(*stored.grid), "a grid that is accepted can be one");
    }
  });
  return 0;
}
