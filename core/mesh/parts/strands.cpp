#include "core/mesh/parts/strands.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/base/disjoint_sets.h"

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr float kCancels = 0.45f;  // flatness below which the normals of a strand's sides cancel
constexpr float kBulges = -0.3f;   // rad: crease below which that is no fold

bool isStrand(const PartGraph& graph, std::uint32_t patch) {
  return graph.flatness[patch] < kCancels && graph.crease[patch] < kBulges;
}

std::uint32_t regionCount(const std::vector<std::uint32_t>& regions) {
  return regions.empty() ? 0 : *std::max_element(regions.begin(), regions.end()) + 1;
}

// Numbers the regions that are left from 0 in the order of their first patches.
void renumber(std::vector<std::uint32_t>& regions) {
  std::vector<std::uint32_t> number(regionCount(regions), kNone);
  std::uint32_t count = 0;
  for (std::uint32_t& region : regions) {
    if (number[region] == kNone) number[region] = count++;
    region = number[region];
  }
}

// Gives the patches around `seed` that hang together with it and are in its region and kind the region `number`.
void flood(const PartGraph& graph, const std::vector<bool>& strand, std::uint32_t seed, std::uint32_t number,
           const std::vector<std::uint32_t>& before, std::vector<std::uint32_t>& regions) {
  std::vector<std::uint32_t> stack{seed};
  regions[seed] = number;
  while (!stack.empty()) {
    const std::uint32_t p = stack.back();
    stack.pop_back();
    for (std::uint32_t i = graph.patches.start[p]; i < graph.patches.start[p + 1]; ++i) {
      const std::uint32_t q = graph.patches.neighbours[i];
      if (regions[q] != kNone || strand[q] != strand[p] || (!strand[p] && before[q] != before[p])) continue;
      regions[q] = number;
      stack.push_back(q);
    }
  }
}

// Regions: their areas, and the lengths of their borders by neighbour.
struct Regions {
  std::vector<double> area;
  std::vector<std::map<std::uint32_t, double>> borders;

  Regions(const PartGraph& graph, const std::vector<std::uint32_t>& regions)
      : area(regionCount(regions), 0), borders(area.size()) {
    for (std::uint32_t p = 0; p < graph.size(); ++p) {
      area[regions[p]] += double(graph.area[p]);
      for (std::uint32_t i = graph.patches.start[p]; i < graph.patches.start[p + 1]; ++i)
        if (const std::uint32_t other = regions[graph.patches.neighbours[i]]; other != regions[p])
          borders[regions[p]][other] += double(graph.border[i]);
    }
  }
};

// Where a strand or a small region goes; itself if nothing is beside it.
std::uint32_t hostOf(const Regions& all, std::uint32_t region, const std::vector<bool>& loose, bool strand) {
  std::uint32_t best = region;
  const auto better = [&](std::uint32_t a, std::uint32_t b) {
    if (loose[a] != loose[b]) return !bool(loose[a]);
    return strand ? all.area[a] < all.area[b] : all.borders[region].at(a) > all.borders[region].at(b);
  };
  for (const auto& [other, length] : all.borders[region])
    if (best == region || better(other, best)) best = other;
  return best;
}

}  // namespace

// A basin that ran along a strand falls apart where that is taken out of it.
std::vector<bool> separateStrands(const PartGraph& graph, std::vector<std::uint32_t>& regions) {
  std::vector<bool> strand(graph.size()), isStrandRegion;
  for (std::uint32_t p = 0; p < graph.size(); ++p) strand[p] = isStrand(graph, p);
  const std::vector<std::uint32_t> before = regions;
  regions.assign(graph.size(), kNone);
  for (std::uint32_t p = 0; p < graph.size(); ++p) {
    if (regions[p] != kNone) continue;
    flood(graph, strand, p, std::uint32_t(isStrandRegion.size()), before, regions);
    isStrandRegion.push_back(strand[p]);
  }
  return isStrandRegion;
}

void joinStrands(const PartGraph& graph, std::vector<std::uint32_t>& regions, const std::vector<bool>& strand,
                 float smallArea) {
  const Regions all(graph, regions);
  std::vector<bool> loose(all.area.size());
  for (std::size_t r = 0; r < loose.size(); ++r) loose[r] = strand[r] || all.area[r] < double(smallArea);
  // The smallest first; one that goes with a loose one goes where that goes.
  std::vector<std::uint32_t> order(loose.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return all.area[a] < all.area[b]; });
  DisjointSets joined(loose.size());
  for (const std::uint32_t r : order) {
    if (!loose[r]) continue;
    joined.joinInto(r, hostOf(all, r, loose, strand[r]));
  }
  for (std::uint32_t& region : regions) region = joined.root(region);
  renumber(regions);
}

}  // namespace sonoskin
