#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_options.h"
#include "core/rbf/csrbf_model.h"
#include "core/surface/surface_points.h"

namespace sonoskin {

// extractIsoSurface: the surface S = 0 of a fitted function, where the points support it.
//   model, points   the points to which the model was fitted, world mm
//   options         resolution: cells along the longest side of the points' box; support, maxGap: a triangle is
//                   kept if at each of its vertices the coverage Σφ is above `support` and a point is closer than
//                   maxGap spacings
//   output          world mm; all pieces; normals from the gradient of S, outward; manifold and oriented, closed
//                   where the points are
//   method          bricks of 4³ samples that follow the surface, the table of marching_cubes_table.h, vertices by
//                   linear interpolation; clipped at vertices because clipping at samples tears small supports
//   cost            time and memory follow the area; 1.3 million triangles: 0.4 s on one core, 100 MB
//   errors          Error: no triangle is left; Cancelled
//   threads         the result does not depend on their number
Mesh extractIsoSurface(const CsrbfModel& model, const SurfacePoints& points, const MeshOptions& options,
                       const Progress& progress = {});

}  // namespace sonoskin
