#pragma once

#include "core/base/fields.h"

namespace sonoskin {

// SurfaceOptions: from the classified volume to oriented points (non-maximum suppression, hysteresis,
// clusters).
struct SurfaceOptions {
  double threshold = 0.10;
  double strongThreshold = 0.45;
  double strongShare = 0.4;
  int minClusterVoxels = 200;
  double facing = 0.3;
  double borderMargin = 4;
};

template <class F, class O>
requires OptionsOf<O, SurfaceOptions>
void fields(F&& f, O& o) {
  f(Field{"threshold", "smallest classified value of a surface voxel", "", "lo"}, o.threshold,
    Range{0.01, 1.0});
  f(Field{"strongThreshold", "classified value of a strong surface voxel", "", "hi"}, o.strongThreshold,
    Range{0.01, 1.0});
  f(Field{"strongShare", "share of strong voxels that a piece needs to be kept"}, o.strongShare,
    Range{0.0, 1.0});
  f(Field{"minClusterVoxels", "smaller pieces are dropped; 1 keeps all", "voxels"}, o.minClusterVoxels,
    Range{1, 1000000});
  f(Field{"facing", "cosine between beam and inward gradient that a surface needs; -1 keeps all"}, o.facing,
    Range{-1.0, 0.99});
  f(Field{"borderMargin", "distance from the border of the scanned region within which nothing is surface",
          "voxels"},
    o.borderMargin, Range{0.0, 32.0});
}

}  // namespace sonoskin
