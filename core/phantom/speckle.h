#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/phantom/sector_grid.h"

namespace sonoskin {

// PointSpread: standard deviations of the pulse's Gaussian point spread function.
struct PointSpread {
  float range = 0.2f;                            // mm
  float lateral = 0.0073f, elevation = 0.0108f;  // rad
};

// NoiseLevels: of the receiver, dB relative to an echo of amplitude 1.
//   receiver   noise of the amplifier at the probe; it rises with depth, by 8 dB over the whole range: the
//              gain that makes up for the attenuation
//   clutter    side lobes and reverberation: part of the echoes within some millimetres, smeared
//   reach      how far that clutter goes: times 1.2 mm by 3 by 3 degrees (standard deviations)
struct NoiseLevels {
  float receiver, clutter, reach = 1;
};

// speckleEnvelope: the envelope of the received signal: independent complex scatterers at every sample,
// weighted by their amplitude, seen through the point spread function; plus clutter and noise.
//   input    amplitude: sector.samples() root mean square echoes; consumed
//   output   sector.samples(), >= 0; where the amplitude is uniform it is Rayleigh distributed (fully
//            developed speckle), with mean square amplitude^2  [Burckhardt 1978]
//   threads  the result does not depend on their number
//   errors   Cancelled
std::vector<float> speckleEnvelope(const SectorGrid& sector, std::vector<float> amplitude,
                                   const PointSpread& spread, const NoiseLevels& noise, int seed,
                                   const Progress& progress = {});

// addClutter: raises each amplitude^2 by clutter times the mean of its neighbourhood's (Gaussian,
// `reach` times 1.2 mm by 3 by 3 degrees).
//   errors   Cancelled
void addClutter(const SectorGrid& sector, std::vector<float>& amplitude, const NoiseLevels& noise,
                const Progress& progress = {});

}  // namespace sonoskin
