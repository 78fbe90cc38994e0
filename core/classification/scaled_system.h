#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/classification/data_term.h"
#include "core/classification/half.h"
#include "core/classification/neighbour_terms.h"

namespace sonoskin {

// ScaledSystem: the system A u = b, A = diag(c) + K, divided by its diagonal D = diag(A): what a sweep of the fast
// solver reads, 9 bytes per voxel with the directions.
//   right, own, inverse   b/D, c/D and 1/D
//   norm                  |b|
//   leastOwn              the smallest c/D: no eigenvalue of D^-1 A is smaller
//   coupling, squares     per tile of tilesOf(dims): the largest share of K in the diagonal, 1 - c/D, and |b|^2
struct ScaledSystem {
  LargeArray<Half> right, own, inverse;
  double norm = 0, leastOwn = 1;
  std::vector<float> coupling, squares;
};

// Where K has no larger share in a voxel's diagonal than this, b/c is its solution to 0.02.
inline constexpr float kLooseCoupling = 0.02f;

// scaleSystem: builds the system, and u to start from, in one pass over the volume.
//   start    room for one value per voxel; gets b/c, the solution where K = 0
//   before   a solution for the system that `system` holds, or null. With it, start gets
//            max(0, before + (b/c)_new - (b/c)_old) where K counts: a change of the iso-value moves the whole surface,
//            so that `before` itself would be farther away than b/c. May be `start` itself.
//   errors   Cancelled; then `system` is of no use
void scaleSystem(const DataSource& source, const NeighbourTerms& k, const float* before, ScaledSystem& system,
                 float* start, const Progress& progress = {});

}  // namespace sonoskin
