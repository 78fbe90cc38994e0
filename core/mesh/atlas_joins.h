#pragma once

#include "core/mesh/atlas_charts.h"

namespace sonoskin {

// JoinLimits: which charts are given away, and what may go wrong.
//   smallest   mm²: charts from this size on stay
//   share      of a chart that may lie over or under the other one; turned away from its axis at most a twelfth
//   hidden     mm² that may lie over or under others in all
struct JoinLimits {
  double smallest = 0, share = 0, hidden = 0;
};

// joinCharts: gives small charts to a neighbour within the limits, the one with the longest common border first.
//   normals   as smoothNormals gives them
void joinCharts(const Facets& facets, const std::vector<glm::vec3>& normals,
                const std::array<ChartAxis, kChartAxes>& axes, JoinLimits limits, Charts& charts);

}  // namespace sonoskin
