#pragma once

#include "core/base/fields.h"

namespace sonoskin {

// SurfaceOptions: from the classified volume to oriented points (non-maximum suppression, hysteresis,
// clusters).
struct SurfaceOptions {
  double threshold = 0.12;
  double strongThreshold = 0.5;
  double strongShare = 0.3;
  double minClusterArea = 60;
  double facing = 0.3;
  double borderMargin = 4;
};

template <class F, class O>
requires OptionsOf<O, SurfaceOptions>
void fields(F&& f, O& o) {
  f(Field{"threshold", "smallest classified value of a surface voxel, as a share of the volume's strongest",
          "", "lo"},
    o.threshold, Range{0.01, 1.0});
  f(Field{"strongThreshold",
          "classified value of a strong surface voxel, as a share of the volume's strongest", "", "hi"},
    o.strongThreshold, Range{0.01, 1.0});
  f(Field{"strongShare", "share of strong voxels that a piece needs to be kept"}, o.strongShare,
    Range{0.0, 1.0});
  f(Field{"minClusterArea", "pieces of the surface that are smaller are dropped; 0 keeps all", "mm²"},
    o.minClusterArea, Range{0.0, 1e5});
  f(Field{"facing", "cosine between beam and inward gradient that a surface needs; -1 keeps all"}, o.facing,
    Range{-1.0, 0.99});
  f(Field{"borderMargin", "distance from the border of the scanned region within which nothing is surface",
          "voxels"},
    o.borderMargin, Range{0.0, 32.0});
}

}  // namespace sonoskin
