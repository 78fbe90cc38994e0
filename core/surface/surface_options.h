#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// ThinningMethod: trilinear steps along grad v~ with sub-voxel positions (thinning.h), or the thesis' 13 directions
// on the blurred u (thesis_thinning.h).
enum class ThinningMethod { trilinear, thesis };
constexpr auto enumNames(ThinningMethod) { return std::array{"trilinear", "thesis"}; }

// ThresholdScale: what the thresholds are shares of.
enum class ThresholdScale { strongest, one };
constexpr auto enumNames(ThresholdScale) { return std::array{"strongest", "one"}; }

// ClusterRule: which connected pieces of surface voxels are kept.
enum class ClusterRule { hysteresis, largest };
constexpr auto enumNames(ClusterRule) { return std::array{"hysteresis", "largest"}; }

// SurfaceOptions: from the classified volume to oriented points (non-maximum suppression, hysteresis,
// clusters).
struct SurfaceOptions {
  ThinningMethod thinning = ThinningMethod::trilinear;
  ThresholdScale thresholdScale = ThresholdScale::strongest;
  double threshold = 0.12;
  double strongThreshold = 0.45;
  ClusterRule clusters = ClusterRule::hysteresis;
  double strongShare = 0.1;
  double minClusterArea = 60;
  double facing = 0.1;
  double borderMargin = 4;
};

template <class F, class O>
requires OptionsOf<O, SurfaceOptions>
void fields(F&& f, O& o) {
  f(Field{"thinning",
          "trilinear: sub-voxel, across the low-passed volume's edges; thesis: whole voxels, 13 directions"},
    o.thinning);
  f(Field{"thresholdScale",
          "what both thresholds are shares of: the volume's strongest surfaces, or 1 as in the thesis"},
    o.thresholdScale);
  f(Field{"threshold", "smallest classified value of a surface voxel, as a share of the threshold scale", "",
          "lo"},
    o.threshold, Range{0.01, 1.0});
  f(Field{"strongThreshold", "classified value of a strong surface voxel, as a share of the threshold scale",
          "", "hi"},
    o.strongThreshold, Range{0.01, 1.0});
  f(Field{"clusters",
          "hysteresis: every piece with enough strong voxels; largest: one piece alone, as the thesis"},
    o.clusters);
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
