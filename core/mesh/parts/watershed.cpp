#include "core/mesh/parts/watershed.h"

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

// The neighbour that bulges most, if it does so more than the patch itself; else the patch. Equal ones are ordered by
// number, so that every way down ends.
std::uint32_t downhill(const PartGraph& graph, std::uint32_t patch) {
  std::uint32_t best = patch;
  for (std::uint32_t i = graph.patches.start[patch]; i < graph.patches.start[patch + 1]; ++i) {
    const std::uint32_t other = graph.patches.neighbours[i];
    if (graph.crease[other] < graph.crease[best] ||
        (graph.crease[other] == graph.crease[best] && other < best))
      best = other;
  }
  return best;
}

}  // namespace

std::vector<std::uint32_t> creaseBasins(const PartGraph& graph) {
  std::vector<std::uint32_t> basin(graph.size(), kNone), way;
  std::uint32_t count = 0;
  for (std::uint32_t p = 0; p < graph.size(); ++p) {
    way.clear();
    std::uint32_t at = p;
    while (basin[at] == kNone) {
      way.push_back(at);
      const std::uint32_t next = downhill(graph, at);
      if (next == at) {
        basin[at] = count++;
        break;
      }
      at = next;
    }
    for (const std::uint32_t passed : way) basin[passed] = basin[at];
  }
  return basin;
}

}  // namespace sonoskin
