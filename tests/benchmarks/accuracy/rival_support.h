#pragma once

#include "core/pipeline/parameters.h"
#include "core/surface/surface_points.h"
#include "core/surface/thinning.h"
#include "core/volume/scan.h"

namespace sonoskin::accuracy {

// frameOf: the beam and the scanned region, found as our chain finds them.
ScanFrame frameOf(const Scan& scan, const Parameters& parameters);

// rivalOptions: the recipe's facing filter and margin, the given threshold, and pieces of 100 voxels or more.
SurfaceOptions rivalOptions(const Parameters& parameters, const Geometry& geometry, double threshold);

// gradientMagnitude: |grad v| per smallest spacing, 0 on the outermost layer.
Volume<float> gradientMagnitude(const Volume<float>& volume);

// finishRival: drops small pieces and gives each voxel its normal.
SurfacePoints finishRival(const std::vector<SurfaceVoxel>& voxels, const Volume<float>& lowPassed,
                          const SurfaceOptions& options);

// accepts: the facing filter and the margin, as thin() has them.
bool accepts(const ScanFrame& frame, const SurfaceOptions& options, const Geometry& geometry,
             const glm::ivec3& voxel, const glm::vec3& gradientPerMm);

}  // namespace sonoskin::accuracy
