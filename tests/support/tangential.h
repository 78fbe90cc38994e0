#pragma once

#include <algorithm>
#include <vector>

#include "core/classification/tangential_operator.h"

namespace sonoskin::test {

// applied: K u on the whole volume, tile by tile.
template <class Values>
std::vector<float> applied(const TangentialOperator& k, const Values& u) {
  std::vector<float> result(u.size());
  for (const Tile& tile : tilesOf(k.geometry().dims))
    k.apply(u.data(), tile, [&](int j, int slice, const float* ku) {
      std::copy_n(ku, tile.last.x - tile.first.x, &result[k.geometry().index(tile.first.x, j, slice)]);
    });
  return result;
}

}  // namespace sonoskin::test
