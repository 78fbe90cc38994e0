#include "core/classification/smoothed.h"

#include "core/base/error.h"
#include "core/volume/gaussian.h"

namespace sonoskin {

Smoothed smooth(const Volume<float>& volume, const ClassificationOptions& options, const Progress& progress) {
  const glm::ivec3 dims = volume.geometry.dims;
  require(glm::min(dims.x, glm::min(dims.y, dims.z)) >= 3,
          "the volume has {}x{}x{} voxels: surfaces need at least 3 along each axis", dims.x, dims.y, dims.z);
  Smoothed smoothed;
  smoothed.lowPassed = gaussianBlur(volume, options.lowPass, progress);
  return smoothed;
}

}  // namespace sonoskin
