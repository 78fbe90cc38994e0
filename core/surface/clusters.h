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

// dropWeakClusters: keeps the pieces of minClusterArea or more with many voxels that reach strongThreshold
// (hysteresis): strongShare of those of the piece with most of them, and a third of minClusterArea, 30 at most. So
// a speck beside a face goes, but in a noisy scan a face that is weak all over stays. A surface voxel stands for the
// area V^(2/3), V: its volume.
//   largest  with ClusterRule::largest only the piece with most voxels, if it has minClusterArea
std::vector<SurfaceVoxel> dropWeakClusters(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry,
                                           const SurfaceOptions& options);

// labelLobes: parts pieces at their necks: voxels with at least 8 others among their 26 neighbours, as the inner ones
// of a sheet have, are joined where they touch; the rest goes with the first such voxel that it touches, or stays
// alone.
//   output   a label per voxel: the index of a voxel of its lobe
std::vector<int> labelLobes(const std::vector<SurfaceVoxel>& voxels, const glm::ivec3& dims);

// dropLooseLobes: drops sheets of other tissue that hang on a piece by a neck: lobes of minClusterArea or more, but
// less than a quarter of the piece's main lobe (the one with most strong voxels), whose share of strong voxels is below
// lobeStrength times the main lobe's. Smaller ones are the torn parts of one sheet, and stay.
//   largest  with ClusterRule::largest everything is kept
std::vector<SurfaceVoxel> dropLooseLobes(const std::vector<SurfaceVoxel>& voxels, const Geometry& geometry,
                                         const SurfaceOptions& options);

}  // namespace sonoskin
