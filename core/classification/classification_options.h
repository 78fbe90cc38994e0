#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// Formulation: which equations are solved; classify.h and thesis_system.h have them.
enum class Formulation { variational, thesisClosed, thesisSkew };
constexpr auto enumNames(Formulation) { return std::array{"variational", "thesis-closed", "thesis-skew"}; }

// GradientSource: the volume whose gradients tell edges.
enum class GradientSource { lowPassed, raw };
constexpr auto enumNames(GradientSource) { return std::array{"low-passed", "raw"}; }

// CurlDifferences: how the skew system takes the curl of a gradient. The gradient itself is central, so central
// differences give exactly zero.
enum class CurlDifferences { forward, central };
constexpr auto enumNames(CurlDifferences) { return std::array{"forward", "central"}; }

// ClassificationOptions: what turns a volume into u, which is near 1 on surfaces. "voxels" are the smallest
// spacing. The thesis' formulations use the seven parameters of its table 3.1 (alpha, beta, gamma, isoValue,
// rawShare, gradientFloor, target) and their own two (curl, rescale); unusedBecause() in parameter_use.h tells.
struct ClassificationOptions {
  Formulation formulation = Formulation::variational;
  double alpha = 1;
  double beta = 1;
  double gamma = 1;
  double isoValue = 0;
  double isoShare = 0.6;
  double rawShare = 0.25;
  GradientSource gradientSource = GradientSource::lowPassed;
  double gradientFloor = 0.1;
  double gradientReference = 0.1;
  double target = 1;
  double lowPass = 1.5;
  double tangentialLength = 3;
  double noiseFloor = 0.05;
  double farthest = 16;
  double directionScale = 0.02;
  CurlDifferences curl = CurlDifferences::forward;
  bool rescale = true;
  double tolerance = 1e-4;
};

template <class F, class O>
requires OptionsOf<O, ClassificationOptions>
void fields(F&& f, O& o) {
  f(Field{"formulation",
          "variational: smooths along surfaces; thesis-closed: equation 3.7, whose matrix is diagonal; "
          "thesis-skew: the same with a curl that does not vanish"},
    o.formulation);
  f(Field{"alpha", "how strongly values away from the iso-value are set to zero", "", "alpha"}, o.alpha,
    Range{0.01, 4.0, true});
  f(Field{"beta", "smoothing along the surface; 1 smooths over the tangential length", "", "beta"}, o.beta,
    Range{0.0, 4.0});
  f(Field{"gamma", "how strongly edges are pulled up to the target value", "", "gamma"}, o.gamma,
    Range{0.01, 4.0, true});
  f(Field{"isoValue", "grey value at the border of the skin; 0 finds one from the volume", "", "v_iso"},
    o.isoValue, Range{0.0, 1.0});
  f(Field{"isoShare",
          "where isoValue is 0: how far it lies on the way from the grey of the fluid to that of the "
          "steepest edges around",
          "", "s"},
    o.isoShare, Range{0.05, 1.5});
  f(Field{"rawShare", "share of the raw volume, against the low-passed one, in the iso-value term", "", "w"},
    o.rawShare, Range{0.0, 1.0});
  f(Field{"gradientSource",
          "volume whose gradients tell edges: low-passed is quiet, raw is sharp where there is little noise"},
    o.gradientSource);
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
  f(Field{"farthest", "distance from the iso-surface beyond which all voxels count as equally far", "voxels",
          "sqrt(a_max)"},
    o.farthest, Range{1.0, 256.0, true});
  f(Field{"directionScale", "gradient per voxel below which a direction is not trusted", "1/voxel", "kappa"},
    o.directionScale, Range{0.001, 0.2, true});
  f(Field{"curl",
          "differences that take the curl in the thesis' term: forward ones leave a rest, central ones none"},
    o.curl);
  f(Field{"rescale",
          "brings the result of the thesis' formulations to 0 .. 1 by its least and greatest value"},
    o.rescale);
  f(Field{"tolerance",
          "relative residual at which the solver stops, for a mesh; sliders are answered to 0.002"},
    o.tolerance, Range{1e-6, 0.1, true});
}

}  // namespace sonoskin
