#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/volume/volume.h"

namespace sonoskin {

// SweepFrames: flat pictures of one size, one after another, rows from the probe on.
//   pixels  width * height * poses.size() of them, i fastest
//   poses   from pixels (i, j, 0, 1) to world mm of each picture; affine, its first two columns not parallel
template <class T>
struct SweepFrames {
  int width = 0, height = 0;
  std::span<const T> pixels;
  std::vector<glm::dmat4> poses;
};

// SweepOptions: how pictures become a volume.
//   spacing  mm between voxels, the same along all axes; 0: the distance of pixels, or of pictures where that
//            is larger but no more than three times; coarser where the box would have more than 2^25 voxels
//   linear   a pixel counts for the eight voxels around it, by how near they are; else for the nearest alone
//   fill     voxels within this many voxels of pictures on both sides are filled from those around them; 0:
//            none
struct SweepOptions {
  double spacing = 0;
  bool linear = true;
  int fill = 3;
};

// SweptVolume: mask is not zero where a picture lay, or a gap between pictures was filled; values elsewhere
// are 0.
struct SweptVolume {
  Volume<float> volume;
  Volume<std::uint8_t> mask;
};

// reconstructSweep: a volume of what tracked pictures show, along the axes of the one in the middle: i along
// its rows, j away from the probe, k from picture to picture.
//   method  each voxel is the mean of its pixels, weighted where `linear`; gaps within the closing of what is
//           covered by a cube of 2 fill + 1 voxels get the Gaussian mean of their surroundings
//           [Rohling 1999, pixel nearest neighbour with hole filling; PLUS's volume reconstructor]
//   errors  Error: no pictures, poses that are none, a box of more than 2^27 voxels; Cancelled
//   cost    O(pixels) and 17 bytes for each voxel of the box; 60 million pixels a second on two cores
template <class T>
SweptVolume reconstructSweep(const SweepFrames<T>& frames, const SweepOptions& options = {},
                             const Progress& progress = {});

}  // namespace sonoskin
