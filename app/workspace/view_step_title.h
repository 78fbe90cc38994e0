#pragma once

#include <string>

#include "app/document/view_edits.h"

namespace sonoskin {

// viewStepTitle: what a step changed of what a person makes in the views: "Distance 12.3 mm", "Distance 12.3 mm deleted",
// "Clip plane moved", "Colours: Bone".
std::string viewStepTitle(const ViewEdits& before, const ViewEdits& after);

}  // namespace sonoskin
