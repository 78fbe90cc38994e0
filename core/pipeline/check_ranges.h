#pragma once

#include "core/pipeline/parameters.h"

namespace sonoskin {

// checkRanges: throws Error (usage) that names the first parameter that is outside its range or not a number.
void checkRanges(const Parameters& parameters);

}  // namespace sonoskin
