#pragma once

#include <vector>

#include "core/surface/thinning.h"

namespace sonoskin {

// growSides: adds to a surface that faces the probe what it is connected to around its sides: the flanks of a finger,
// the underside of a nose or a jaw, so that what overhangs does not end in a free edge.
//   kept     the surface, in the order of memory
//   others   voxels that do not face the probe, in the order of memory; none of `kept`
//   reach    mm, along the surface from the nearest voxel of `kept`; 0 adds nothing
//   method   shortest ways over 26-connected voxels [Dijkstra 1959]
//   output   in the order of memory
std::vector<SurfaceVoxel> growSides(const std::vector<SurfaceVoxel>& kept,
                                    const std::vector<SurfaceVoxel>& others, const Geometry& geometry,
                                    double reach);

}  // namespace sonoskin
