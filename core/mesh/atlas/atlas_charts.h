#pragma once

#include "core/mesh/atlas/atlas_axes.h"
#include "core/mesh/facets.h"

namespace sonoskin {

// The least cosine between the normal of a chart and its axis.                                    [theory/skin.md, 3.2]
inline constexpr float kLeastFacing = 0.3f;

// Charts: which triangles are projected together, and along which of the 14 axes.
struct Charts {
  std::vector<std::uint32_t> ofTriangle;
  std::vector<std::uint32_t> axis;  // per chart

  std::size_t size() const { return axis.size(); }
};

// smoothNormals: per triangle the unit normal of the surface around it, over `length` mm.
//   errors   Cancelled
std::vector<glm::vec3> smoothNormals(const Facets& facets, float length, const Progress& progress = {});

// labelTriangles: per triangle the axis nearest to its normal; the first one, the front, is favoured. Single triangles
// between others are given to them.
//   normals  as smoothNormals gives them
//   errors   Cancelled
std::vector<std::uint32_t> labelTriangles(const Facets& facets, const std::vector<glm::vec3>& normals,
                                          const std::array<ChartAxis, kChartAxes>& axes,
                                          const Progress& progress = {});
std::uint32_t nearestAxis(const glm::vec3& normal, const std::array<ChartAxis, kChartAxes>& axes,
                          float frontBias);

// connectedCharts: a chart for each connected set of triangles with the same key.
//   axisOfKey   per key
//   errors      Cancelled
Charts connectedCharts(const Facets& facets, const std::vector<std::uint32_t>& keys,
                       const std::vector<std::uint32_t>& axisOfKey, const Progress& progress = {});

// mergeSmallCharts: gives charts below `smallest` mm² to the neighbour with the longest common border, among those
// whose axis they face; without such a one only charts below `tiny` mm² are given away.
void mergeSmallCharts(const Facets& facets, const std::array<ChartAxis, kChartAxes>& axes, double smallest,
                      double tiny, Charts& charts);

}  // namespace sonoskin
