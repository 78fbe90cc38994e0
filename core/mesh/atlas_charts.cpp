#include "core/mesh/atlas_charts.h"

#include <map>
#include <set>

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr float kFacing =
    0.3f;  // least cosine between a chart's normal and its axis   [skin specification, 4.1]

// Region: a chart while charts are merged.
struct Region {
  double area = 0;
  glm::vec3 normal{0};                      // sum over its triangles
  std::map<std::uint32_t, double> borders;  // length of the border with each neighbour, mm
};

std::vector<Region> regionsOf(const Facets& facets, const Charts& charts) {
  std::vector<Region> regions(charts.size());
  for (std::size_t t = 0; t < facets.size(); ++t) {
    Region& region = regions[charts.ofTriangle[t]];
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
    regions[a].borders[b] += double(glm::length(to - from));
  }
  return regions;
}

// The neighbour with the longest border, if asked for only among those whose axis the region faces; kNone without one.
std::uint32_t bestNeighbour(const Region& region, const Charts& charts,
                            const std::array<ChartAxis, kChartAxes>& axes, bool mustFace) {
  std::uint32_t best = kNone;
  double longest = -1;
  for (const auto& [other, length] : region.borders) {
    const glm::vec3& toward = axes[charts.axis[other]].toward;
    if (mustFace && glm::dot(region.normal, toward) < kFacing * glm::length(region.normal)) continue;
    if (length <= longest) continue;
    longest = length;
    best = other;
  }
  return best;
}

void merge(std::vector<Region>& regions, std::uint32_t from, std::uint32_t into) {
  for (const auto& [other, length] : regions[from].borders) {
    regions[other].borders.erase(from);
    if (other == into) continue;
    regions[other].borders[into] += length;
    regions[into].borders[other] += length;
  }
  regions[into].area += regions[from].area;
  regions[into].normal += regions[from].normal;
  regions[from].borders.clear();
}

// Charts without a triangle are dropped, the others keep their order.
void renumber(Charts& charts, const std::vector<std::uint32_t>& mergedInto) {
  std::vector<std::uint32_t> number(charts.size(), kNone), axis;
  for (std::uint32_t c = 0; c < charts.size(); ++c) {
    if (mergedInto[c] != c) continue;
    number[c] = std::uint32_t(axis.size());
    axis.push_back(charts.axis[c]);
  }
  for (std::uint32_t c = 0; c < charts.size(); ++c) {
    std::uint32_t root = c;
    while (mergedInto[root] != root) root = mergedInto[root];
    number[c] = number[root];
  }
  for (std::uint32_t& c : charts.ofTriangle) c = number[c];
  charts.axis = std::move(axis);
}

}  // namespace

Charts connectedCharts(const Facets& facets, const std::vector<std::uint32_t>& keys,
                       const std::vector<std::uint32_t>& axisOfKey, const Progress& progress) {
  Charts charts;
  charts.ofTriangle.assign(facets.size(), kNone);
  std::vector<std::uint32_t> stack;
  std::size_t visited = 0;
  for (std::uint32_t seed = 0; seed < facets.size(); ++seed) {
    if (charts.ofTriangle[seed] != kNone) continue;
    const auto number = std::uint32_t(charts.size());
    charts.axis.push_back(axisOfKey[keys[seed]]);
    charts.ofTriangle[seed] = number;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      if (++visited % 65536 == 0) progress.update(double(visited) / double(facets.size()));
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const std::uint32_t other = facets.opposite[h] == kNoHalfEdge ? t : facets.opposite[h] / 3;
        if (charts.ofTriangle[other] != kNone || keys[other] != keys[t]) continue;
        charts.ofTriangle[other] = number;
        stack.push_back(other);
      }
    }
  }
  return charts;
}

void mergeSmallCharts(const Facets& facets, const std::array<ChartAxis, kChartAxes>& axes, double smallest,
                      double tiny, Charts& charts) {
  std::vector<Region> regions = regionsOf(facets, charts);
  std::vector<std::uint32_t> mergedInto(charts.size());
  std::set<std::pair<double, std::uint32_t>> bySize;
  for (std::uint32_t c = 0; c < charts.size(); ++c) {
    mergedInto[c] = c;
    if (regions[c].area < smallest) bySize.emplace(regions[c].area, c);
  }
  while (!bySize.empty()) {
    const std::uint32_t c = bySize.begin()->second;
    bySize.erase(bySize.begin());
    std::uint32_t into = bestNeighbour(regions[c], charts, axes, true);
    if (into == kNone && regions[c].area < tiny) into = bestNeighbour(regions[c], charts, axes, false);
    if (into == kNone) continue;
    const bool wasSmall = bySize.erase({regions[into].area, into}) > 0;
    merge(regions, c, into);
    mergedInto[c] = into;
    if (wasSmall && regions[into].area < smallest) bySize.emplace(regions[into].area, into);
  }
  renumber(charts, mergedInto);
}

}  // namespace sonoskin
