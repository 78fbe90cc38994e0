#include "core/phantom/phantom.h"

#include <cmath>
#include <memory>

#include "core/base/error.h"
#include "core/phantom/acoustics.h"
#include "core/phantom/display.h"
#include "core/phantom/phantom_geometry.h"
#include "core/phantom/scene_acoustics.h"
#include "core/phantom/speckle.h"

namespace sonoskin {
namespace {

constexpr float kSoftTissue = -30;       // dB; the mean echo of the baby's soft tissue, to which `snr` refers
constexpr float kClutterOverNoise = 22;  // dB; relative to the echoes around, as side lobes are

// noiseLevels: a poor signal comes with poor contrast (thick belly, little fluid), so both follow `snr`.
NoiseLevels noiseLevels(double snr, const SceneAcoustics& acoustics) {
  const float noise = kSoftTissue - float(snr);
  return {noise + acoustics.receiver, noise + kClutterOverNoise + acoustics.clutter, acoustics.clutterReach};
}

void quantise(Volume<float>& volume) {
  for (float& v : volume.data) v = std::round(v * 255) / 255;
}

}  // namespace

Scan makePhantomScan(const PhantomOptions& options, const Progress& progress) {
  const Geometry geometry = phantomGeometry(options);
  const SceneAcoustics acoustics = sceneAcoustics(options.scene);
  const SectorGrid sector = sceneSector(options);
  std::vector<float> signal;
  {
    const Anatomy anatomy = sampleAnatomy(PhantomModel(options), anatomySpacing(geometry),
                                          acoustics.haze.reach, progress.part(0, 0.25));
    signal = echoAmplitude(sector, anatomy, options.seed, acoustics, progress.part(0.25, 0.55));
  }
  signal = speckleEnvelope(sector, std::move(signal), acoustics.spread, noiseLevels(options.snr, acoustics),
                           options.seed, progress.part(0.55, 0.85));
  showEnvelope(sector, acoustics.display, signal, progress.part(0.85, 0.9));
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
