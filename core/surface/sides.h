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

// dropBareSides: takes out what turns its back to the probe with nothing before it: the inside of a surface whose outside
// was not recorded. What faces the probe, or nearly, stays; so does what lies behind something that does, such as the
// underside of a finger.
//   voxels   in the order of memory
//   output   in the same order
//   errors   Cancelled
std::vector<SurfaceVoxel> dropBareSides(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry,
                                        const Beam& beam, const Progress& progress = {});

}  // namespace sonoskin
