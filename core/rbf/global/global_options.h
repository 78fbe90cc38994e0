#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// GlobalBasis: φ(r); c = 1/width².
//   biharmonic           -r
//   triharmonic          r³
//   thinPlate            r² log r
//   gaussian             exp(-c r²)
//   multiquadric         -sqrt(1 + c r²)
//   inverseMultiquadric  1/sqrt(1 + c r²)
//   wendland             (1 - t)^4 (4t + 1), t = r/width
enum class GlobalBasis {
  biharmonic,
  triharmonic,
  thinPlate,
  gaussian,
  multiquadric,
  inverseMultiquadric,
  wendland
};
constexpr std::array<const char*, 7> enumNames(GlobalBasis) {
  return {"biharmonic",   "triharmonic",         "thinPlate", "gaussian",
          "multiquadric", "inverseMultiquadric", "wendland"};
}

// GlobalOptions: one radial basis function over all points (Carr et al. 2001; thesis 2.3.2).
struct GlobalOptions {
  GlobalBasis basis = GlobalBasis::biharmonic;
  int degree = 1;
  double width = 3;
  double offset = 1;
  double offsetShare = 0.5;
  double accuracy = 0.5;
  double nugget = 10;
  double tolerance = 1e-4;
  int maxCentres = 40000;
};

template <class F, class O>
requires OptionsOf<O, GlobalOptions>
void fields(F&& f, O& o) {
  f(Field{"basis", "the radial function; the harmonic ones and thinPlate have no width"}, o.basis);
  f(Field{"degree",
          "degree of the polynomial, -1: none; at least 0 for biharmonic and multiquadric, 1 for triharmonic "
          "and thinPlate"},
    o.degree, Range{-1, 2});
  f(Field{"width", "width of gaussian, multiquadric, inverseMultiquadric; support of wendland", "mm"},
    o.width, Range{0.1, 1000.0, true});
  f(Field{"offset", "distance of the points off the surface; halved where another part of it is nearer",
          "mm"},
    o.offset, Range{0.05, 20.0, true});
  f(Field{"offsetShare", "share of the points that have points off the surface, on both sides"},
    o.offsetShare, Range{0.05, 1.0});
  f(Field{"accuracy",
          "points that the surface misses by more become centres, until there are none; 0: every point is "
          "one",
          "mm"},
    o.accuracy, Range{0.0, 10.0});
  f(Field{"nugget",
          "smoothing: added to the diagonal of the system, as a multiple of what the basis changes over the "
          "offset",
          "", "rho"},
    o.nugget, Range{0.0, 1e6});
  f(Field{"tolerance", "residual of the solver, as a share of the right side"}, o.tolerance,
    Range{1e-10, 1e-1, true});
  f(Field{"maxCentres", "more centres than this are refused: time grows with their square", "centres"},
    o.maxCentres, Range{100, 200000});
}

}  // namespace sonoskin
