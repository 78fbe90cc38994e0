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
  double strongShare = 0.06;
  double lobeStrength = 0.6;
  double minClusterArea = 60;
  double facing = 0.1;
  double sides = 5;
  double borderMargin = 4;
  double firstHit = 15;
  bool offsetCorrection = true;
  double skinDepth = 0.85;
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
  f(Field{"strongShare",
          "strong voxels that a piece needs to be kept, as a share of those of the piece with most of them"},
    o.strongShare, Range{0.0, 1.0});
  f(Field{"lobeStrength",
          "sheets that hang on a piece by a neck are dropped if their share of strong voxels is below this "
          "times the "
          "piece's; 0 keeps all"},
    o.lobeStrength, Range{0.0, 1.0});
  f(Field{"minClusterArea", "pieces of the surface that are smaller are dropped; 0 keeps all", "mm²"},
    o.minClusterArea, Range{0.0, 1e5});
  f(Field{"facing", "cosine between beam and inward gradient that a surface needs; -1 keeps all"}, o.facing,
    Range{-1.0, 0.99});
  f(Field{"sides",
          "how far around its sides a surface that faces the probe is followed, so that what overhangs is "
          "whole; 0 "
          "leaves them out",
          "mm"},
    o.sides, Range{0.0, 20.0});
  f(Field{"borderMargin", "distance from the border of the scanned region within which nothing is surface",
          "voxels"},
    o.borderMargin, Range{0.0, 32.0});
  f(Field{"firstHit",
          "depth behind a surface within which another one is dropped, such as bone below skin, unless fluid "
          "lies "
          "between; 0 keeps all",
          "mm"},
    o.firstHit, Range{0.0, 40.0});
  f(Field{"offsetCorrection",
          "move each point along its normal to where the grey rises most steeply, and from there onto the "
          "skin"},
    o.offsetCorrection);
  f(Field{"skinDepth",
          "how far behind the steepest rise the skin lies, as a share of the way in which the grey rises "
          "from 20 to 80 %"},
    o.skinDepth, Range{0.0, 2.0});
}

}  // namespace sonoskin
