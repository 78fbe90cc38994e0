#pragma once

#include <string>

#include "core/base/hash.h"
#include "core/pipeline/parameters.h"

namespace sonoskin {

// writeRecipe: JSON with every parameter, the program's version and the input's fingerprint; no patient data.
std::string writeRecipe(const Parameters& parameters, const Key& input = {});

// readRecipe: sets the parameters that the recipe names and leaves the others.
//   errors   Error: not JSON, an unknown group or field, a value of the wrong kind or out of range, by name
void readRecipe(const std::string& json, Parameters& parameters);

}  // namespace sonoskin
