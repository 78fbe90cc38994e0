#pragma once

#include "core/base/progress.h"
#include "core/volume/volume.h"

namespace sonoskin {

// quantile: the value below which a share of the voxels lies, to 1/1024.
//   volume   values in [0, 1]; others count as the nearest of the two
//   share    0 to 1
//   cost     one pass
//   errors   Cancelled
double quantile(const Volume<float>& volume, double share, const Progress& progress = {});

}  // namespace sonoskin
