#pragma once

#include <array>
#include <vector>

namespace sonoskin {

// Places: a parameter that is a list of points, mm; empty by default.
using Places = std::vector<std::array<double, 3>>;

}  // namespace sonoskin
