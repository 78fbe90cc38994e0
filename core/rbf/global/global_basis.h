#pragma once

#include "core/rbf/global/global_options.h"

namespace sonoskin {

// RadialKernel: φ(r) with its width; see GlobalBasis for the seven forms. The signs make Σ λ_i λ_j φ(|x_i - x_j|) > 0
// for all λ whose moments up to the minimum degree vanish.
//   width   in the unit of the positions; > 0; the harmonic ones and thinPlate have none
struct RadialKernel {
  GlobalBasis basis = GlobalBasis::biharmonic;
  double width = 1;
};

// minimumDegree: the lowest polynomial degree with which a basis can interpolate any values; -1: none is needed.
int minimumDegree(GlobalBasis basis);

bool hasWidth(GlobalBasis basis);

// kernelVariation: how much φ changes over a distance: |φ(r) - φ(0)|; r² for thinPlate, whose logarithm depends on the
// unit. What is measured by it, as the nugget, means the same in any unit and about the same for any basis.
double kernelVariation(const RadialKernel& kernel, double distance);

// kernelValue: φ(r), from r².
double kernelValue(const RadialKernel& kernel, double squared);

}  // namespace sonoskin
