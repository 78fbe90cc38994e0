#pragma once

#include "core/mesh/atlas_charts.h"

namespace sonoskin {

// joinCharts: gives charts below `smallest` mm² to a neighbour, the one with the longest common border first, where next
// to nothing of them then lies over or under that chart or turned away from its axis.
//   normals   as smoothNormals gives them
//   allowed   share of a chart that may; turned away at most a twelfth
void joinCharts(const Facets& facets, const std::vector<glm::vec3>& normals,
                const std::array<ChartAxis, kChartAxes>& axes, double smallest, double allowed,
                Charts& charts);

}  // namespace sonoskin
