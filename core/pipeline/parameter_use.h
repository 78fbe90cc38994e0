#pragma once

#include <string_view>

#include "core/pipeline/parameters.h"

namespace sonoskin {

// unusedBecause: why a parameter has no effect beside the others' present values, as a sentence for a tooltip
// without a full stop; empty where it has one.
//   group, field   names as in forEachField(), such as "classification", "beta"
std::string_view unusedBecause(const Parameters& parameters, std::string_view group, std::string_view field);

}  // namespace sonoskin
