#pragma once

#include "core/base/progress.h"
#include "core/classification/neighbour_terms.h"
#include "core/classification/scaled_system.h"

namespace sonoskin {

// FastSolution: how the fast solver ended.
//   residual  |b - A u| / |b|, of each tile as its last sweep met it: the answer's is smaller
//   updates   voxels written, over all sweeps
struct FastSolution {
  bool converged = false;  // false: the steps grew instead of shrinking, or it took 100 sweeps
  double residual = 0;
  int sweeps = 0;
  std::size_t updates = 0;
};

// solveFast: A u = b by Chebyshev's iteration on D^-1 A, matrix-free, with coefficients in half precision.
//   solves    u_{n+1} = u_n + omega_n (u_n - u_{n-1}) + s_n D^-1 (b - A u_n)   [Golub, Varga 1961]
//             the eigenvalues of D^-1 A lie between those that ScaledSystem and NeighbourTerms tell
//   stops     where |b - A u| / |b| is below the tolerance. A tile rests as soon as the same holds in it alone,
//             none of its voxels would move by more than twice the tolerance, and no neighbour moves by eight times
//             as much. 2e-3 is within 0.02 of the solution everywhere; for less than 5e-4 the coefficients' 11 bits
//             are too few: solvePcg
//   u         in: where to start; out: the solution.   scratch: as large, of no use afterwards
//   cost      21 bytes per voxel and sweep: u, the one before, coefficients, directions
//   errors    Cancelled, within a sweep
// The result does not depend on the number of threads.
FastSolution solveFast(const NeighbourTerms& k, const ScaledSystem& system, double tolerance,
                       LargeArray<float>& u, LargeArray<float>& scratch, const Progress& progress = {});

}  // namespace sonoskin
