#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/volume/volume.h"

namespace sonoskin {

// marchingCubes: the surface where `field` crosses `level`.
//   field    any size; NaN marks values that are undefined: a cell with one makes no triangle
//   output   world mm; inside is field < level; counter-clockwise from outside (turned if the grid mirrors);
//            closed and manifold except at undefined cells and at the grid's border; without normals
//   method   the table of marching_cubes_table.h; vertices by linear interpolation  [Lorensen, Cline 1987; table ours]
//   errors   Error: more vertices than 32 bits can number; Cancelled
Mesh marchingCubes(const Volume<float>& field, float level, const Progress& progress = {});

}  // namespace sonoskin
