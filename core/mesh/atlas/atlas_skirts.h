#pragma once

#include "core/mesh/atlas/atlas_charts.h"

namespace sonoskin {

// chartSkirts: for each chart the triangles of others within `reach` mm of its border along the edges of the mesh that
// face its axis, the nearest first.
//   cost     as many steps as skirts have triangles, times their logarithm
//   errors   Cancelled
std::vector<std::vector<std::uint32_t>> chartSkirts(const Facets& facets,
                                                    const std::array<ChartAxis, kChartAxes>& axes,
                                                    const Charts& charts, float reach,
                                                    const Progress& progress = {});

}  // namespace sonoskin
