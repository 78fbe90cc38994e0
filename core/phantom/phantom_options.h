#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// PhantomScene: what makes the simulated scan hard.
//   clear      a good scan: thin echoes, clean fluid
//   thick      long pulses and wide beams: thick echoes, smeared sideways
//   haze       clutter in the fluid before the skin
//   saturated  bright echoes are cut off at white
//   enhanced   the scanner set fluid and shadow to 0
//   planes     coarse planes in elevation, 1.6 mm apart
//   turned     the head is turned away from the probe and tilted
//   attached   placenta and wall touch cheek and shoulder, membranes between
//   cord       the cord lies over a cheek
//   hands      hands in other places
//   clinical   most of these at once, as in real scans
enum class PhantomScene {
  clear,
  thick,
  haze,
  saturated,
  enhanced,
  planes,
  turned,
  attached,
  cord,
  hands,
  clinical
};
constexpr auto enumNames(PhantomScene) {
  return std::array{"clear",  "thick",    "haze", "saturated", "enhanced", "planes",
                    "turned", "attached", "cord", "hands",     "clinical"};
}

// PhantomOptions: the simulated scan of a sleeping newborn.
struct PhantomOptions {
  std::array<int, 3> dims{467, 255, 124};  // fewer voxels are larger ones: the field of view keeps its size
  PhantomScene scene = PhantomScene::clear;
  int shape = 0;
  double snr = 20;
  int seed = 1;
};

template <class F, class O>
requires OptionsOf<O, PhantomOptions>
void fields(F&& f, O& o) {
  f(Field{"dims", "voxels of the simulated volume", "voxels"}, o.dims, Range{16, 1024});
  f(Field{"scene", "what makes the scan hard; clear: nothing much"}, o.scene);
  f(Field{"shape", "another number gives another head: size, proportions, features; 0 is the first one"},
    o.shape, Range{0, 1000000});
  f(Field{"snr", "echo of soft tissue over the noise of the receiver; 0 is very noisy, 40 nearly clean",
          "dB"},
    o.snr, Range{0.0, 60.0});
  f(Field{"seed", "another number gives another pattern of speckle"}, o.seed, Range{0, 1000000});
}

}  // namespace sonoskin
