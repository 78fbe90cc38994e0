#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/print/print_options.h"

namespace sonoskin {

// makePrintSolid: a solid that can be printed, from an open surface.
//   surface  one or more pieces; holes in them are closed, their outer borders become rims
//   output   closed, manifold, oriented, nothing crosses; world mm times options.scale; with normals. Shells of pieces
//            that lie apart stay apart; pieces below a hundredth of the largest are dropped; a surface without a border
//            gives the solid that it encloses.
//   method   the level set of a function on a grid of cubic cells, 400 along the longest side, by marching cubes, so
//            that nothing can fold over: for shell the wall's (wall_field.h), for block the union of the wall and of
//            what lies behind it (relief.h), cut by a plane. "Behind" is against the mean of the surface's normals.
//   accuracy the front lies within a tenth of a cell of the surface except at sharp edges; undercuts of a block that
//            the mean normal does not see are filled
//   cost     for 3 mm, in parallel: 180,000 triangles of a face 7 s of one core, 290,000 with many folds about 20 s
//   errors   Error: form is none, no triangles, or a thickness below 2.5 cells; Cancelled
//   threads  the result does not depend on their number
Mesh makePrintSolid(const Mesh& surface, const PrintOptions& options, const Progress& progress = {});

}  // namespace sonoskin
