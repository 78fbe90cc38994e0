#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/volume/volume.h"

namespace sonoskin {

// fillGaps: gives values to voxels without any that lie between others.
//   input   radius  voxels
//           mask    not zero where `volume` has values; of the same geometry
//   output  both, with the gaps filled: those in the closing of the mask by a cube of 2 radius + 1 voxels, by
//           the mean of the values around them, weighted by a Gaussian of half the radius [normalised
//           convolution, Knutsson 1993]; voxels that had a value keep it
//   cost    O(voxels * radius); 8 bytes for each voxel
void fillGaps(int radius, Volume<float>& volume, Volume<std::uint8_t>& mask, const Progress& progress = {});

}  // namespace sonoskin
