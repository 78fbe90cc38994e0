#pragma once

#include <map>

#include "core/base/disjoint_sets.h"
#include "core/mesh/atlas/atlas_charts.h"

namespace sonoskin {

// Region: a chart while charts are merged.
//   normal    sum over its triangles
//   borders   mm of common border with each neighbour
struct Region {
  double area = 0;
  glm::vec3 normal{0};
  std::map<std::uint32_t, double> borders;

  bool faces(const glm::vec3& toward) const;  // as much as a chart must
};

// ChartRegions: the charts of a surface as a graph.
class ChartRegions {
 public:
  ChartRegions(const Facets& facets, const Charts& charts);
  std::size_t size() const { return regions_.size(); }
  const Region& operator[](std::size_t chart) const { return regions_[chart]; }
  void merge(std::uint32_t from, std::uint32_t into);
  // apply: the charts after all merges; those that are left keep their order.
  void apply(Charts& charts);

 private:
  std::vector<Region> regions_;
  DisjointSets merged_;
};

}  // namespace sonoskin
