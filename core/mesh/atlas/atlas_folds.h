#pragma once

#include "core/mesh/atlas/atlas_charts.h"

namespace sonoskin {

// splitFolds: moves triangles that lie hidden behind others of their chart, with a margin, and those turned away from
// their axis into charts of their own.
//   normals    as smoothNormals gives them
//   method     depth pictures of each chart; hidden is what lies more than 0.8 mm behind. Three rounds, for a moved
//              part may fold again; parts below `tiny` mm² go back to a neighbour.
//                                                                                      [theory/skin.md, 3.2, step 5]
//   errors     Cancelled
struct FoldOptions {
  double tiny = 0;
  float unit = 1;  // the method's lengths are so many times as long, see AtlasOptions
};
void splitFolds(const Facets& facets, const std::vector<glm::vec3>& normals,
                const std::array<ChartAxis, kChartAxes>& axes, const FoldOptions& options, Charts& charts,
                const Progress& progress = {});

}  // namespace sonoskin
