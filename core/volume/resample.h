#pragma once

#include "core/base/progress.h"
#include "core/volume/volume.h"

namespace sonoskin {

// halveResolution: each voxel is the mean of up to 2x2x2; axes whose spacing is already 1.6 times the
// smallest are kept, so that voxels become rounder. The world frame stays.
//   errors   Cancelled
Volume<float> halveResolution(const Volume<float>& volume, const Progress& progress = {});

// halveMask: the mask of such a volume: 1 where all voxels that became one were inside, else 0.
Volume<std::uint8_t> halveMask(const Volume<std::uint8_t>& mask, const Progress& progress = {});

// cropVolume: the part of a volume that begins at voxel `first` and has `dims` voxels; it stays where it is in the world.
//   errors   Error: no voxel along an axis, or not inside the volume
template <class T>
Volume<T> cropVolume(const Volume<T>& volume, const glm::ivec3& first, const glm::ivec3& dims);

}  // namespace sonoskin
