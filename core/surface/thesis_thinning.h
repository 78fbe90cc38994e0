#pragma once

#include <vector>

#include "core/surface/thinning.h"

namespace sonoskin {

// thinByThesis: non-maximum suppression as the thesis does it, to compare with thin().
//   value       u~, the mean of u over 3x3x3 voxels
//   direction   of grad u~ per voxel, rounded to the nearest of the 13 directions to the 26 neighbours
//   keeps       u~(x) > u~ of both neighbours along it, u~ >= threshold
//   position    the voxel itself: no part of a voxel
//   facing, border   as thin() has them; the thesis has neither (facing -1, borderMargin 0)
//   output      in the order of the voxels
//   errors      Cancelled
std::vector<SurfaceVoxel> thinByThesis(const Volume<float>& classified, const Volume<float>& lowPassed,
                                       const ScanFrame& frame, const SurfaceOptions& options,
                                       const Progress& progress = {});

// nearestOf13: the step to one of the 26 neighbours whose line is nearest to the gradient's; the gradient's sign
// does not matter. `gradient` must not be zero.
glm::ivec3 nearestOf13(const glm::vec3& gradient);

}  // namespace sonoskin
