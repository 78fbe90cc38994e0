#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_options.h"
#include "core/rbf/compact/csrbf_model.h"
#include "core/rbf/implicit_function.h"
#include "core/surface/surface_points.h"

namespace sonoskin {

// meshCell: the edge of the cells in which the surface is sought, mm: options.cell, or the longest side of the points'
// box by options.resolution.
//   errors   Error: all points lie at one place; more than 4000 cells along one side
float meshCell(const std::vector<glm::vec3>& points, const MeshOptions& options);

// extractIsoSurface: the surface S = 0 of a fitted function, where the points support it.
//   function   made for meshCell(points, options)
//   points     the points to which it was fitted, world mm
//   options    density, support, maxGap: the surface ends where points are less dense than that, the coverage Σφ is below
//              `support`, or no point is closer than maxGap spacings; the border is smoothed along the surface, and parts
//              narrower than `narrowest` spacings go. Gaps up to `fillHoles` mm that the surface surrounds, and over
//              which the points are not farther than maxGap, are closed by the function
//   output     world mm; all pieces; normals from the gradient of S, outward; `measured`: 1 amid points, 0 at the border
//              and in closed gaps; manifold and oriented, closed where the points are
//   method     bricks of 4³ samples that follow the surface, the table of marching_cubes_table.h, vertices by linear
//              interpolation; triangles are cut at the border
//   cost       time and memory follow the area
//   errors     Error: no triangle is left; Cancelled
//   threads    the result does not depend on their number
Mesh extractIsoSurface(const ImplicitFunction& function, const SurfacePoints& points,
                       const MeshOptions& options, const Progress& progress = {});

// The same for a fitted model; its function is made on the way.
//   errors     Error: no points or no centres, and as above
Mesh extractIsoSurface(const CsrbfModel& model, const SurfacePoints& points, const MeshOptions& options,
                       const Progress& progress = {});

}  // namespace sonoskin
