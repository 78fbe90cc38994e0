#pragma once

#include "core/base/progress.h"
#include "core/volume/volume.h"

namespace sonoskin {

// boxBlur: means of 3x3x3 voxels, whatever the spacing; the border's values are repeated beyond the border.
//   cost     12 bytes of traffic per voxel
//   errors   Cancelled
Volume<float> boxBlur(const Volume<float>& volume, const Progress& progress = {});

// boxBlurRow: the row (j, k) of boxBlur.
//   scratch  dims.x + 2 values
//   out      dims.x values
void boxBlurRow(const Volume<float>& volume, int j, int k, float* scratch, float* out);

}  // namespace sonoskin
