#pragma once

#include "core/base/fields.h"

namespace sonoskin {

// ClassificationOptions: the variational filter (spec: minimise alpha a u^2 + beta |grad u x g|^2 +
// gamma h (u - uind)^2). "voxels" are the smallest spacing.
struct ClassificationOptions {
  double alpha = 1;
  double beta = 1;
  double gamma = 1;
  double isoValue = 0;
  double rawShare = 0.25;
  double gradientFloor = 0.1;
  double gradientReference = 0.1;
  double target = 1;
  double lowPass = 1.5;
  double tangentialLength = 3;
  double noiseFloor = 0.05;
  double directionScale = 0.02;
  double tolerance = 1e-3;
};

template <class F, class O>
requires OptionsOf<O, ClassificationOptions>
void fields(F&& f, O& o) {
  f(Field{"alpha", "how strongly values away from the iso-value are set to zero", "", "alpha"}, o.alpha,
    Range{0.01, 4.0, true});
  f(Field{"beta", "smoothing along the surface; 1 smooths over the tangential length", "", "beta"}, o.beta,
    Range{0.0, 4.0});
  f(Field{"gamma", "how strongly edges are pulled up to the target value", "", "gamma"}, o.gamma,
    Range{0.01, 4.0, true});
  f(Field{"isoValue", "grey value at the border of the skin; 0 finds one from the volume", "", "v_iso"},
    o.isoValue, Range{0.0, 1.0});
  f(Field{"rawShare", "share of the raw volume, against the low-passed one, in the iso-value term", "", "w"},
    o.rawShare, Range{0.0, 1.0});
  f(Field{"gradientFloor", "pull toward the target where there is no gradient", "", "delta"}, o.gradientFloor,
    Range{0.0, 0.99});
  f(Field{"gradientReference", "gradient per voxel that counts as a full edge", "1/voxel", "g_ref"},
    o.gradientReference, Range{0.01, 1.0, true});
  f(Field{"target", "value that surfaces get", "", "u_ind"}, o.target, Range{0.5, 1.0});
  f(Field{"lowPass", "width (standard deviation) of the low-pass filter", "voxels", "sigma"}, o.lowPass,
    Range{0.3, 4.0});
  f(Field{"tangentialLength", "distance over which beta = 1 smooths along the surface", "voxels", "l"},
    o.tangentialLength, Range{0.0, 8.0});
  f(Field{"noiseFloor", "difference from the iso-value that counts as noise", "", "nf"}, o.noiseFloor,
    Range{0.0, 0.2});
  f(Field{"directionScale", "gradient per voxel below which a direction is not trusted", "1/voxel", "kappa"},
    o.directionScale, Range{0.001, 0.2, true});
  f(Field{"tolerance", "relative residual at which the solver stops"}, o.tolerance, Range{1e-6, 0.1, true});
}

}  // namespace sonoskin
