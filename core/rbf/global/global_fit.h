#pragma once

#include "core/rbf/global/global_points.h"
#include "core/rbf/global/global_rbf.h"

namespace sonoskin {

// fitGlobal: a global radial basis function through oriented points.
//   method   Greedy: a fit through some thousand points spread over all; then those that it misses most are added, the
//            worst of every neighbourhood, until all that it misses by more than `accuracy` are centres: without a
//            nugget it then misses none. Points beside the surface, whose distances are only as good as the normals,
//            may be missed by half their distance. With accuracy 0 every point is a centre. Each fit is by FGMRES with a domain decomposition before it.
//   cost     time grows with the square of the centres: 10k: 1 s, 20k: 4 s of one core; 12 KB per centre
//   errors   Error: see checkPoints; the degree is below what the basis needs; the points do not determine the
//            polynomial; more than maxCentres are needed; the solver does not reach its tolerance. Cancelled
//   threads  the result does not depend on their number
GlobalRbf fitGlobal(const SurfacePoints& points, const GlobalOptions& options, const Progress& progress = {});

// fitGlobal: the same through given values.
//   errors   as above, but for what is wrong with surface points
GlobalRbf fitGlobal(const GlobalPoints& points, const GlobalOptions& options, const Progress& progress = {});

}  // namespace sonoskin
