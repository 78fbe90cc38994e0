#pragma once

#include "core/mesh/parts/part_graph.h"

namespace sonoskin {

// separateStrands: gives every strand of the surface, thinner than about twice the graph's scale, a region of its own.
//   regions  per patch, numbered from 0 without gaps; numbered so again afterwards
//   output   per region, whether it is a strand
//   method   the normals around a patch cancel and it bulges
std::vector<bool> separateStrands(const PartGraph& graph, std::vector<std::uint32_t>& regions);

// joinStrands: gives strands, and regions smaller than `smallArea` mm², to a region beside them: a strand between several
// goes with the smallest of these, so that a large one keeps no stump; other ones go where their border is longest. What
// has no neighbour stays.
//   regions  as above
//   strand   per region
void joinStrands(const PartGraph& graph, std::vector<std::uint32_t>& regions, const std::vector<bool>& strand,
                 float smallArea);

}  // namespace sonoskin
