#include "core/mesh/atlas/atlas_regions.h"

namespace sonoskin {

bool Region::faces(const glm::vec3& toward) const {
  return glm::dot(normal, toward) >= kLeastFacing * glm::length(normal);
}

ChartRegions::ChartRegions(const Facets& facets, const Charts& charts)
    : regions_(charts.size()), merged_(charts.size()) {
  for (std::size_t t = 0; t < facets.size(); ++t) {
    Region& region = regions_[charts.ofTriangle[t]];
    region.area += double(facets.area(t));
    region.normal += facets.normal[t];
  }
  const std::vector<Triangle>& triangles = facets.mesh.triangles;
  for (std::uint32_t h = 0; h < facets.opposite.size(); ++h) {
    if (facets.opposite[h] == kNoHalfEdge) continue;
    const std::uint32_t a = charts.ofTriangle[h / 3], b = charts.ofTriangle[facets.opposite[h] / 3];
    if (a == b) continue;
    const glm::vec3 &from = facets.mesh.positions[originOf(triangles, h)],
                    &to = facets.mesh.positions[originOf(triangles, nextHalfEdge(h))];
    regions_[a].borders[b] += double(glm::length(to - from));
  }
}

void ChartRegions::merge(std::uint32_t from, std::uint32_t into) {
  for (const auto& [other, length] : regions_[from].borders) {
    regions_[other].borders.erase(from);
    if (other == into) continue;
    regions_[other].borders[into] += length;
    regions_[into].borders[other] += length;
  }
  regions_[into].area += regions_[from].area;
  regions_[into].normal += regions_[from].normal;
  regions_[from].borders.clear();
  merged_.joinInto(from, into);
}

void ChartRegions::apply(Charts& charts) {
  std::vector<std::uint32_t> number(charts.size()), axis;
  for (std::uint32_t c = 0; c < charts.size(); ++c) {
    if (!merged_.isRoot(c)) continue;
    number[c] = std::uint32_t(axis.size());
    axis.push_back(charts.axis[c]);
  }
  for (std::uint32_t c = 0; c < charts.size(); ++c) number[c] = number[merged_.root(c)];
  for (std::uint32_t& c : charts.ofTriangle) c = number[c];
  charts.axis = std::move(axis);
}

}  // namespace sonoskin
