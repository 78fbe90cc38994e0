#pragma once

#include <string>

#include "app/document/document.h"

namespace sonoskin {

// stepTitle: what a step of the history changed, in a few words: "α 1 → 1.4", "Erased 1,240 voxels", "Crop box",
// "Distance 12.3 mm".
std::string stepTitle(const Version& before, const Version& after);

}  // namespace sonoskin
