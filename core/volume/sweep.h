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

// SweptVolume: mask is not zero where a picture lay, or a gap between pictures was filled; values elsewhere
// are 0.
struct SweptVolume {
  Volume<float> volume;
  Volume<std::uint8_t> mask;
};

// reconstructSweep: a volume of what tracked pictures show, along the axes of the one in the middle: i along
// its rows, j away from the probe, k from picture to picture.
//   method  each voxel is the mean of its pixels: one counts for the eight voxels around it, by how near they
//           are; gaps within the closing of what is covered by a cube of 7 voxels get the Gaussian mean of
//           their surroundings
//           [after Rohling 1999, pixel-based with hole filling; PLUS's volume reconstructor, linear]
//   output  voxels as far apart as pixels, or as pictures where that is larger but no more than three times;
//           farther where the box would have more than 2^25 voxels
//   errors  Error: no pictures, poses that are none, a box of more than 2^27 voxels; Cancelled
//   cost    O(pixels) and 17 bytes for each voxel of the box; 60 million pixels a second on two cores
template <class T>
SweptVolume reconstructSweep(const SweepFrames<T>& frames, const Progress& progress = {});

}  // namespace sonoskin
