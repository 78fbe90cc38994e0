// What a process that reads volumes answers, were it led astray by its file; and the intensities made of that.
#include <cmath>

#include "core/io/normalise.h"
#include "core/io/reader_wire.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::attempt([&] {
    const LoadedVolume loaded = volumeFrom({data, size}, "a.nrrd");
    for (const bool outside : {false, true}) {
      const NormalisedVolume n = normalise(loaded.stored, loaded.numbers, {}, outside);
      for (const float v : n.volume.data) fuzz::claim(v >= 0 && v <= 1, "intensities are from 0 to 1");
      fuzz::claim(
          std::isfinite(n.originalMin) && std::isfinite(n.originalMax) && n.originalMin < n.originalMax,
          "the range of the file can be shown");
    }
  });
  return 0;
}
