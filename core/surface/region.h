#pragma once

#include <cstdint>
#include <memory>

#include "core/surface/region_options.h"
#include "core/volume/scan.h"
#include "core/volume/volume.h"

namespace sonoskin {

// Region: the part of a volume in which the surface is sought: a box of voxels, without what was erased. What lies
// outside counts as if it were fluid: it is no surface and hides none.
//   first, last  the box's voxels, both of them inside
//   erased       not zero where nothing counts; may be missing
struct Region {
  glm::ivec3 first{0}, last{1 << 30};
  std::shared_ptr<const Volume<std::uint8_t>> erased{};

  bool contains(const glm::ivec3& voxel) const {
    return glm::all(glm::greaterThanEqual(voxel, first)) && glm::all(glm::lessThanEqual(voxel, last)) &&
           !(erased && erased->at(voxel.x, voxel.y, voxel.z));
  }
};

// regionOf: the region that the options and the scan's erased parts leave. A voxel is in the box if its centre is.
//   errors  Error: nothing is left of the box
Region regionOf(const Scan& scan, const RegionOptions& options);

// isWhole: whether nothing was cut away from the volume, and nothing erased.
bool isWhole(const Region& region, const Geometry& geometry);

// withinRegion: the volume cut to the region's box, zero where something was erased; the volume itself where the region
// is whole. For views of it.
//   volume  of the geometry that the region was made for
std::shared_ptr<const Volume<float>> withinRegion(const std::shared_ptr<const Volume<float>>& volume,
                                                  const Region& region);

}  // namespace sonoskin
