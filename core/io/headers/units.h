#pragma once

#include <optional>
#include <string_view>

namespace sonoskin {

// millimetresIn: of the unit of length that a header names, in any case, one or many: "cm", "µm", "inches".
//   output  nothing where the word is no unit of length that is known here
std::optional<double> millimetresIn(std::string_view unit);
// millimetresOrWarn: the same; 1, and a warning, where the word is not known; 1 where there is none.
double millimetresOrWarn(std::string_view unit);

// secondsIn: of the unit of time that a header names: "s", "ms", "us".
std::optional<double> secondsIn(std::string_view unit);

}  // namespace sonoskin
