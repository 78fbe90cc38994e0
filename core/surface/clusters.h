#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/surface/surface_options.h"
#include "core/surface/thinning.h"

namespace sonoskin {

// labelClusters: numbers 26-connected pieces of surface voxels.
//   voxels   in the order of memory (k, then j, then i), none twice
//   dims     of their volume
//   output   a label per voxel: the index of the first voxel of its piece
std::vector<int> labelClusters(const std::vector<SurfaceVoxel>& voxels, const glm::ivec3& dims);

// dropWeakClusters: keeps the pieces with at least minClusterVoxels voxels, of which a strongShare (and at
// least a third of minClusterVoxels, 30 at most) reach strongThreshold (hysteresis).
std::vector<SurfaceVoxel> dropWeakClusters(const std::vector<SurfaceVoxel>& voxels, const glm::ivec3& dims,
                                           const SurfaceOptions& options);

}  // namespace sonoskin
