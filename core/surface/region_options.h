#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// RegionOptions: the box of the volume in which the surface is sought.
struct RegionOptions {
  std::array<double, 3> cutLow{0, 0, 0};
  std::array<double, 3> cutHigh{0, 0, 0};
};

template <class F, class O>
requires OptionsOf<O, RegionOptions>
void fields(F&& f, O& o) {
  f(Field{"cutLow", "cut away at the low end of the volume's axes i, j, k", "mm"}, o.cutLow, Range{0.0, 1e4});
  f(Field{"cutHigh", "cut away at the high end of the volume's axes i, j, k", "mm"}, o.cutHigh,
    Range{0.0, 1e4});
}

}  // namespace sonoskin
