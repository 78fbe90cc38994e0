#pragma once

#include "core/mesh/atlas/atlas.h"
#include "core/mesh/atlas/atlas_pack.h"

namespace sonoskin {

// ChartOutline: the rows of texels that a chart may touch in each of its columns, from `low` to one before `high`; low is
// not below high where it touches none.
struct ChartOutline {
  std::vector<int> low, high;
};

// packOutlines: charts let down onto those that lie already, the highest first, each where it comes to lie lowest; at least
// `gutter` texels from each other and from the picture's sides.                                  [Lévy et al. 2002, 4.2]
//   cost     the picture's width times the sum of the charts' widths, some 16 of such steps a nanosecond
Packing packOutlines(const std::vector<ChartOutline>& outlines, int gutter);

// nestCharts: moves the charts of an atlas closer together, where that makes it smaller.
//   placed    where each chart's box lies
//   cost      350,000 triangles in 150 charts: 0.02 s
void nestCharts(const std::vector<glm::ivec2>& placed, int gutter, Atlas& atlas);

}  // namespace sonoskin
