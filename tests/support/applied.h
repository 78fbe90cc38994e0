#pragma once

#include <algorithm>
#include <vector>

#include "core/classification/tiles.h"

namespace sonoskin::test {

// applied: K u on the whole volume, tile by tile, for one term or their sum.
template <class Operator, class Values>
std::vector<float> applied(const Operator& k, const Values& u) {
  std::vector<float> result(u.size());
  for (const Tile& tile : tilesOf(k.geometry().dims))
    k.apply(u.data(), tile, [&](int j, int slice, const float* ku) {
      std::copy_n(ku, tile.last.x - tile.first.x, &result[k.geometry().index(tile.first.x, j, slice)]);
    });
  return result;
}

}  // namespace sonoskin::test
