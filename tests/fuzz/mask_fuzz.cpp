// A mask and an erased volume of any geometry and type over a small scan.
#include "core/io/normalise.h"
#include "core/volume/mask_depth.h"
#include "core/volume/scan.h"
#include "tests/fuzz/stored_volumes.h"

using namespace sonoskin;

namespace {

constexpr std::size_t kMostVoxels = 4096;

// As readMarks has it, from the rest of the input.
Scan marks(StoredVolume stored, fuzz::Numbers& numbers) {
  checkGeometry(stored, "mask.nrrd");
  require(stored.geometry.voxels() <= kMostVoxels, "too large for a target");
  std::vector<std::uint8_t> bytes(stored.geometry.voxels() * std::size_t(stored.components) *
                                  numberTypeBytes(stored.type));
  for (std::uint8_t& byte : bytes) byte = numbers.next<std::uint8_t>();
  NormalisedVolume n = normalise(stored, bytes, {}, false);
  Scan scan;
  scan.volume = std::make_shared<const Volume<float>>(std::move(n.volume));
  scan.originalMin = n.originalMin;
  scan.originalMax = n.originalMax;
  scan.spacingKnown = stored.spacingKnown;
  return scan;
}

Scan smallScan() {
  Scan scan;
  Geometry g;
  g.dims = {5, 4, 3};
  g.spacing = {0.5, 0.6, 0.7};
  scan.volume = std::make_shared<const Volume<float>>(g);
  return scan;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers numbers({data, size});
  fuzz::attempt([&] {
    const StoredVolume stored = fuzz::storedVolume(numbers);
    const Scan read = marks(stored, numbers);
    Scan scan = smallScan();
    setErased(scan, read);
    fuzz::claim(scan.erased->data.size() == scan.volume->data.size(),
                "what is erased lies on the scan's grid");
    setMask(scan, read);
    fuzz::claim(scan.mask->data.size() == scan.volume->data.size(), "the mask lies on the scan's grid");
    maskDepth(*scan.mask);
  });
  return 0;
}
