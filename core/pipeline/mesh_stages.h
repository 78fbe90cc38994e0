#pragma once

#include "core/pipeline/found_points.h"
#include "core/pipeline/results.h"
#include "core/pipeline/stage_run.h"

namespace sonoskin {

// MeshInput: what a mesh is made from.
//   beam  of the scan: who chooses parts or pieces looks along it
//   face  nothing where none was looked for
struct MeshInput {
  const Keyed<FoundPoints>& found;
  const Keyed<FaceFit>& face;
  const Beam& beam;
};

// makeMesh: the stages from points to a mesh and a solid of it: fit, pieces, parts, those that are kept, cleaned. All are
// remembered.
//   results  takes what is made
//   output   the key of the mesh: that of StageKeys, or another one where the input was made with short cuts
//   errors   Error: there are no points, the fit has none to hold on to, nothing is kept; see fitSurface, extractIsoSurface,
//            choosePiece, keepAsAsked, cleanMesh and makePrintSolid; Cancelled
Key makeMesh(const StageContext& context, const MeshInput& input, Results& results);

}  // namespace sonoskin
