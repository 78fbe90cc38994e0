#include "core/surface/region.h"

#include <cmath>

#include "core/base/error.h"
#include "core/volume/resample.h"

namespace sonoskin {
namespace {

// A cut of a whole number of voxels keeps the voxel it ends at, whatever the rounding.
constexpr double kTolerance = 1e-6;  // voxels

}  // namespace

Region regionOf(const Scan& scan, const RegionOptions& options) {
  const Geometry& g = scan.volume->geometry;
  Region region;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = std::size_t(axis);
    const double low = std::ceil(options.cutLow[a] / g.spacing[axis] - kTolerance),
                 high = std::floor(g.dims[axis] - 1 - options.cutHigh[a] / g.spacing[axis] + kTolerance);
    require(low <= high,
            "nothing is left of axis {}: region.cutLow and region.cutHigh take {:.1f} and {:.1f} mm off its "
            "{:.1f} mm",
            "ijk"[axis], options.cutLow[a], options.cutHigh[a], (g.dims[axis] - 1) * g.spacing[axis]);
    region.first[axis] = int(low);
    region.last[axis] = int(high);
  }
  region.erased = scan.erased;
  return region;
}

bool isWhole(const Region& region, const Geometry& geometry) {
  return !region.erased && region.first == glm::ivec3(0) && region.last == geometry.dims - 1;
}

std::shared_ptr<const Volume<float>> withinRegion(const std::shared_ptr<const Volume<float>>& volume,
                                                  const Region& region) {
  if (isWhole(region, volume->geometry)) return volume;
  auto part =
      std::make_shared<Volume<float>>(cropVolume(*volume, region.first, region.last - region.first + 1));
  const glm::ivec3 dims = part->geometry.dims;
  for (int k = 0; k < dims.z && region.erased; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        if (!region.contains(region.first + glm::ivec3(i, j, k))) part->at(i, j, k) = 0;
  return part;
}

}  // namespace sonoskin
