#pragma once

#include "core/base/progress.h"
#include "core/classification/data_term.h"
#include "core/classification/neighbour_terms.h"

namespace sonoskin {

// Solution: what the solver found and how well.
struct Solution {
  LargeArray<float> u;
  int iterations = 0;
  double residual = 0;  // |b - A u| / |b|
};

// solvePcg: (diag(c) + K) u = b by conjugate gradients, preconditioned by the diagonal.
//   method   starts from b/c, which is the solution where K = 0; matrix-free  [Hestenes, Stiefel 1952]
//   stops    at `tolerance` of the relative residual, or after 200 iterations
//   cost     67 bytes per voxel and iteration; 7-15 iterations to 1e-3; takes 33 bytes per voxel with the
//            two volumes and the directions that the term was made from; consumes the term
//   errors   Cancelled, within a sweep
// The sums run per slice and then over slices in order: the result does not depend on the number of threads.
Solution solvePcg(const NeighbourTerms& k, DataTerm term, double tolerance, const Progress& progress = {});

}  // namespace sonoskin
