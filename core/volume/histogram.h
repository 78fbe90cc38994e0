#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/volume/volume.h"

namespace sonoskin {

// histogram: how many voxels have each value, in 1024 bins from 0 to 1; others count as the nearest of the two.
//   cost     one pass
//   errors   Cancelled
std::vector<std::uint64_t> histogram(const Volume<float>& volume, const Progress& progress = {});

// quantile: the value below which a share of the voxels lies, to 1/1024.
//   volume   values in [0, 1]; others count as the nearest of the two
//   share    0 to 1
//   cost     one pass
//   errors   Cancelled
double quantile(const Volume<float>& volume, double share, const Progress& progress = {});

}  // namespace sonoskin
