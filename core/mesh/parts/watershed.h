#pragma once

#include "core/mesh/parts/part_graph.h"

namespace sonoskin {

// creaseBasins: the basins that water would fill if creases were ridges: every patch belongs to the most bulging place that
// it reaches by going downhill, so that borders run along creases [Mangan and Whitaker 1999, watershed on surfaces].
//   output   per patch a number; basins are numbered in the order of their first patches
//   cost     O(n)
std::vector<std::uint32_t> creaseBasins(const PartGraph& graph);

}  // namespace sonoskin
