#include "core/mesh/atlas/atlas_rim.h"

namespace sonoskin {

std::vector<RimSide> rimSides(const Facets& facets, const Atlas& atlas) {
  std::vector<RimSide> sides;
  for (std::uint32_t h = 0; h < facets.opposite.size(); ++h) {
    const std::uint32_t g = facets.opposite[h], t = h / 3, corner = h % 3;
    // The other side runs the other way.
    if (g != kNoHalfEdge && atlas.corners[t][corner] == atlas.corners[g / 3][nextHalfEdge(g) % 3] &&
        atlas.corners[t][(corner + 1) % 3] == atlas.corners[g / 3][g % 3] &&
        atlas.chart[t] == atlas.chart[g / 3])
      continue;
    sides.push_back({t, corner});
  }
  return sides;
}

}  // namespace sonoskin
