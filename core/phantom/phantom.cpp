#include "core/phantom/phantom.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/phantom/acoustics.h"
#include "core/phantom/phantom_geometry.h"
#include "core/phantom/speckle.h"

namespace sonoskin {
namespace {

constexpr float kWhite = -4;             // dB; the echo that is shown white
constexpr float kDynamicRange = 50;      // dB from white to black
constexpr float kSoftTissue = -30;       // dB; the mean echo of the baby's soft tissue, to which `snr` refers
constexpr float kClutterOverNoise = 22;  // dB; relative to the echoes around, as side lobes are

// noiseLevels: a poor signal comes with poor contrast (thick belly, little fluid), so both follow `snr`.
NoiseLevels noiseLevels(double snr) {
  const float receiver = kSoftTissue - float(snr);
  return {receiver, receiver + kClutterOverNoise};
}

// compressLog: envelope to grey in [0, 1].
void compressLog(const SectorGrid& sector, std::vector<float>& envelope, const Progress& progress) {
  constexpr float kScale = 20 / kDynamicRange, kOffset = 1 - kWhite / kDynamicRange;
  const std::size_t slab = sector.row(0, 1);
  parallelFor(
      sector.elevations,
      [&](std::ptrdiff_t k) {
        float* v = envelope.data() + std::size_t(k) * slab;
        for (std::size_t n = 0; n < slab; ++n)
          v[n] = std::clamp(kScale * std::log10(v[n] + 1e-9f) + kOffset, 0.f, 1.f);
      },
      progress);
}

void quantise(Volume<float>& volume) {
  for (float& v : volume.data) v = std::round(v * 255) / 255;
}

}  // namespace

Scan makePhantomScan(const PhantomOptions& options, const Progress& progress) {
  const Geometry geometry = phantomGeometry(options);
  const SectorGrid sector = phantomSector(geometry.spacing);
  std::vector<float> signal;
  {
    const Anatomy anatomy =
        sampleAnatomy(PhantomModel(options), anatomySpacing(geometry), progress.part(0, 0.25));
    signal = echoAmplitude(sector, anatomy, options.seed, progress.part(0.25, 0.55));
  }
  signal = speckleEnvelope(sector, std::move(signal), PointSpread{}, noiseLevels(options.snr), options.seed,
                           progress.part(0.55, 0.85));
  compressLog(sector, signal, progress.part(0.85, 0.9));
  Volume<float> volume = scanConvert(sector, signal, geometry, progress.part(0.9, 1));
  quantise(volume);

  Scan scan;
  scan.beam = Beam{glm::dvec3(sector.apex), {0, 1, 0}, {-1, 0, 0}};
  scan.originalMin = 0;
  scan.originalMax = 255;
  scan.originalType = "uint8";
  scan.key = scanKey(volume, scan.beam);
  scan.volume = std::make_shared<const Volume<float>>(std::move(volume));
  return scan;
}

}  // namespace sonoskin
