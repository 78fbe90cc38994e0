#pragma once

#include "core/base/progress.h"
#include "core/classification/data_term.h"
#include "core/classification/half.h"
#include "core/classification/neighbour_terms.h"

namespace sonoskin {

// PcgSystem: (diag(c) + K) u = b, and the memory that its solution takes beside u, which the next system uses again.
//   u          in: b, and in the known slices u; out: the solution
//   known      slices from k = 0 on whose u is known; the others are solved for
//   diagonal   c
//   r, p, q    residual, search direction, A p
//   inverse    1 / diag(A); any positive numbers would do for a preconditioner
struct PcgSystem {
  float* u = nullptr;
  int known = 0;
  LargeArray<float> diagonal, r, p, q;
  LargeArray<Half> inverse;
};

// PcgEnd: how well it was solved.
struct PcgEnd {
  int iterations = 0;
  double residual = 0;  // |b - A u| / |b|
};

// solvePcg: (diag(c) + K) u = b by conjugate gradients, preconditioned by the diagonal.
//   method   starts from b/c, which is the solution where K = 0; matrix-free  [Hestenes, Stiefel 1952]
//   stops    at `tolerance` of the relative residual, or after 200 iterations
//   cost     63 bytes of traffic per voxel and iteration; 7-15 iterations to 1e-3; takes 25 bytes per voxel with u and
//            the directions
//   errors   Cancelled, within a sweep
// The sums run per slice and then over slices in order: the result does not depend on the number of threads.
PcgEnd solvePcg(const NeighbourTerms& k, PcgSystem& system, double tolerance, const Progress& progress = {});

// Solution: what the solver found and how well.
struct Solution {
  LargeArray<float> u;
  int iterations = 0;
  double residual = 0;  // |b - A u| / |b|
};

// The same of a whole volume; consumes the term.
Solution solvePcg(const NeighbourTerms& k, DataTerm term, double tolerance, const Progress& progress = {});

}  // namespace sonoskin
