#include "core/pipeline/prepared.h"

namespace sonoskin {

// What lies outside the recorded region is told by the scan's own zeros, which enhancement may blur.
Prepared prepare(const Scan& scan, const Volume<float>& input, const Parameters& parameters,
                 const Progress& progress) {
  Prepared result;
  result.smoothed = smooth(input, parameters.classification, progress.part(0, 0.7));
  const Beam beam = beamOf(scan, parameters.scan);
  result.view = findFieldOfView(scan, beam, progress.part(0.7, 1));
  result.beam = beamWithin(result.view, beam, scan.volume->geometry, parameters.scan);
  result.smoothed.levels = proposeLevels(result.smoothed.lowPassed, result.view, result.beam);
  return result;
}

}  // namespace sonoskin
