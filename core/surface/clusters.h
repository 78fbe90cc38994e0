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

// dropWeakClusters: keeps the pieces of minClusterArea or more, of which a strongShare reaches strongThreshold
// (hysteresis). A surface voxel stands for the area V^(2/3), V: its volume.
//   largest  with ClusterRule::largest only the piece with most voxels, if it has minClusterArea
//   fewest   a piece also needs a third of minClusterArea in strong voxels, 30 of them at most
std::vector<SurfaceVoxel> dropWeakClusters(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry,
                                           const SurfaceOptions& options);

}  // namespace sonoskin
