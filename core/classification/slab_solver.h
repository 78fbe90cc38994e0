#pragma once

#include "core/base/progress.h"
#include "core/classification/data_term.h"
#include "core/volume/volume.h"

namespace sonoskin {

// solveInSlabs: u of the variational formulation, to options.tolerance, in slabs of slices, so that the solver's memory is
// that of one slab.
//   method   alternating Schwarz in one pass [Schwarz 1870]: a slab is solved together with some slices beyond it, and
//            starts from the last slice of the one before. What the slices beyond leave out is wrong by less than e^-8
//            in the slab itself: the system's solution forgets within couplingLength()
//   cost     21 bytes per voxel of a slab beside u; a sixth more work than in one piece
//   errors   Cancelled
// A slab is solved to the tolerance in itself. The result does not depend on the number of threads.
Volume<float> solveInSlabs(const DataSource& source, const Progress& progress = {});

// SlabPlan: how many slices there are in a slab, and how many beyond it are solved with it.
struct SlabPlan {
  int slices, beyond;
};
SlabPlan planSlabs(const Geometry& geometry, const ClassificationOptions& options);

}  // namespace sonoskin
