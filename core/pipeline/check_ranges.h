#pragma once

#include "core/pipeline/parameters.h"

namespace sonoskin {

// checkRanges: throws Error (usage) that names the first parameter that is outside its range or not a number.
void checkRanges(const Parameters& parameters);

// withinRanges: parameters that checkRanges lets through: a number outside its range takes the nearer end, what is no
// number the least, and an unfinished stroke of mesh.partsCut is left out.
Parameters withinRanges(Parameters parameters);

}  // namespace sonoskin
