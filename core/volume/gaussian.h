#pragma once

#include "core/base/progress.h"
#include "core/volume/volume.h"

namespace sonoskin {

// gaussianBlur: low-pass by a Gaussian that is round in millimetres.
//   sigma    standard deviation in units of the smallest spacing, >= 0; along coarser axes it spans fewer voxels
//   method   separable, cut at 3 sigma, normalised, border values repeated
//   cost     16 bytes of traffic per voxel; 467x255x124 with sigma 1.5: about 130 ms of one core
//   errors   Cancelled
Volume<float> gaussianBlur(const Volume<float>& volume, double sigma, const Progress& progress = {});

// gaussianKernel: weights at -r..r voxels, sum 1; r = ceil(3 sigma).
std::vector<float> gaussianKernel(double sigmaVoxels);

}  // namespace sonoskin
