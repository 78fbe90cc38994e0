#pragma once

#include "core/skin/landmark_options.h"

namespace sonoskin {

// phantomLandmarks: the places of the simulated baby's face, to a tenth of a millimetre.
LandmarkOptions phantomLandmarks();

// hasLandmarks: whether any is set.
bool hasLandmarks(const LandmarkOptions& landmarks);

}  // namespace sonoskin
