#pragma once

#include "core/classification/classification_options.h"

namespace sonoskin {

// coarserOptions: the same filter for voxels that are `factor` times as large: lengths shrink, gradients grow.
//   the sweeps of thesis-skew become thesis-closed: what its curl leaves grows with the voxels, so that it might
//   refuse what the full volume allows
inline ClassificationOptions coarserOptions(ClassificationOptions o, double factor) {
  o.lowPass /= factor;
  o.tangentialLength /= factor;
  o.farthest /= factor;
  o.gradientReference *= factor;
  o.directionScale *= factor;
  o.alpha *= factor * factor;  // the iso-value term is a squared distance
  if (o.formulation == Formulation::thesisSkew) o.formulation = Formulation::thesisClosed;
  return o;
}

}  // namespace sonoskin
