#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/phantom/scene_acoustics.h"
#include "core/phantom/sector_grid.h"

namespace sonoskin {

// showEnvelope: turns the envelope into grey in [0, 1], in place: logarithmic compression, then, where the
// options say so, smoothing and a threshold, as scanners do before they render.
//   errors   Cancelled
void showEnvelope(const SectorGrid& sector, const DisplayOptions& options, std::vector<float>& envelope,
                  const Progress& progress = {});

}  // namespace sonoskin
