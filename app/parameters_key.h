#pragma once

#include "core/base/hash.h"
#include "core/pipeline/parameters.h"

namespace sonoskin {

// Fingerprints of the parameters that something depends on: equal keys, equal results.
Key parametersKey(const Parameters& parameters);  // all of them
Key classifiedKey(const Parameters& parameters);  // the classified volume
Key pointsKey(const Parameters& parameters);      // and the surface points
Key meshKey(const Parameters& parameters);        // and the mesh

}  // namespace sonoskin
