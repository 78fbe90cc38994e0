#pragma once

#include "core/phantom/phantom_options.h"
#include "core/skin/landmark_options.h"

namespace sonoskin {

// phantomLandmarks: the places of a simulated baby's face, to a tenth of a millimetre.
LandmarkOptions phantomLandmarks(const PhantomOptions& options = {});

// hasLandmarks: whether any is set.
bool hasLandmarks(const LandmarkOptions& landmarks);

}  // namespace sonoskin
