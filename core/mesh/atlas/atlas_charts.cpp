#include "core/mesh/atlas/atlas_charts.h"

#include <set>

#include "core/mesh/atlas/atlas_regions.h"

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr float kFacing =
    0.3f;  // least cosine between a chart's normal and its axis   [theory/skin.md, 3.2, step 4]

// The neighbour with the longest border, if asked for only among those whose axis the region faces; kNone without one.
std::uint32_t bestNeighbour(const Region& region, const Charts& charts,
                            const std::array<ChartAxis, kChartAxes>& axes, bool mustFace) {
  std::uint32_t best = kNone;
  double longest = -1;
  for (const auto& [other, length] : region.borders) {
    if (mustFace && !region.faces(axes[charts.axis[other]].toward)) continue;
    if (length <= longest) continue;
    longest = length;
    best = other;
  }
  return best;
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
  ChartRegions regions(facets, charts);
  std::set<std::pair<double, std::uint32_t>> bySize;
  for (std::uint32_t c = 0; c < charts.size(); ++c)
    if (regions[c].area < smallest) bySize.emplace(regions[c].area, c);
  while (!bySize.empty()) {
    const std::uint32_t c = bySize.begin()->second;
    bySize.erase(bySize.begin());
    std::uint32_t into = bestNeighbour(regions[c], charts, axes, true);
    if (into == kNone && regions[c].area < tiny) into = bestNeighbour(regions[c], charts, axes, false);
    if (into == kNone) continue;
    const bool wasSmall = bySize.erase({regions[into].area, into}) > 0;
    regions.merge(c, into);
    if (wasSmall && regions[into].area < smallest) bySize.emplace(regions[into].area, into);
  }
  regions.apply(charts);
}

}  // namespace sonoskin
