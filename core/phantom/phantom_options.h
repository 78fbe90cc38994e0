#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// PhantomOptions: the simulated scan of a sleeping newborn.
struct PhantomOptions {
  std::array<int, 3> dims{467, 255, 124};  // fewer voxels are larger ones: the field of view keeps its size
  double snr = 20;
  int seed = 1;
};

template <class F, class O>
requires OptionsOf<O, PhantomOptions>
void fields(F&& f, O& o) {
  f(Field{"dims", "voxels of the simulated volume", "voxels"}, o.dims, Range{16, 1024});
  f(Field{"snr", "echo of soft tissue over the noise of the receiver; 0 is very noisy, 40 nearly clean",
          "dB"},
    o.snr, Range{0.0, 60.0});
  f(Field{"seed", "another number gives another pattern of speckle"}, o.seed, Range{0, 1000000});
}

}  // namespace sonoskin
