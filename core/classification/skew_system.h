#pragma once

#include "core/base/progress.h"
#include "core/classification/classification_options.h"
#include "core/volume/volume.h"

namespace sonoskin {

// SkewSolution: the solution of the thesis' seven-point system and how it was found.
struct SkewSolution {
  Volume<float> u;  // as solved: neither clamped nor rescaled
  int sweeps = 0;
  double residual = 0;   // |D^-1 (b - A u)| / |D^-1 b|, D: the diagonal of A
  double dominance = 0;  // greatest sum of |off-diagonals| / diagonal of a row; sweeps converge below 1
};

// solveSkewSystem: A u = b with the rows of equation 3.7, of which the outermost voxels have the diagonal alone.
//   row       [-cz/2 -cy/2 -cx/2  alpha a + gamma h  cx/2 cy/2 cz/2],  c = beta grad v~ x curl grad v~
//             a, h, v~ as in thesis_system.h; the gradient by central differences, the curl as options.curl says
//   method    Jacobi on the whole of A: u <- (b - C u) / d, from u = b / d. The thesis' program ran conjugate
//             gradients on one triangle of A, which solves another, symmetric system.
//   stops     when a sweep's starting residual, scaled by D, is below options.tolerance
//   cost      28 bytes per voxel and sweep; 24 bytes of memory per voxel beside the volume
//   errors    Error: dominance is 1 or more, so that sweeps may diverge, or 1000 sweeps were not enough; Cancelled
// Sums run per slice and then over slices in order: the result does not depend on the number of threads.
SkewSolution solveSkewSystem(const Volume<float>& volume, const ClassificationOptions& options,
                             const Progress& progress = {});

}  // namespace sonoskin
