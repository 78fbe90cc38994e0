#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// NormalisedVolume: intensities in [0, 1], and what 0 and 1 were in the file.
struct NormalisedVolume {
  Volume<float> volume;
  double originalMin = 0, originalMax = 1;  // what 0 and 1 stand for
  double valueMin = 0,
         valueMax = 0;  // least and greatest finite value in the file, but for padding that it names
};

// normalise: turns the numbers of a file into intensities.
//   input   numbers  as LoadedVolume has them
//           outside  whether padding is looked for besides that which the file names; marks have none
//   output  8-bit types: the type's range becomes [0, 1]. Others: that of values which fill half of 0 to 1, 255 or
//           65535, so that a scan is the same in any type; else the 0.05th and the 99.95th percentile of what was recorded
//           become 0 and 1 and values beyond are clamped: a wide type's range says nothing (CT uses 4,000 of 65,536
//           values) and a few stray values must not darken all others. Where that leaves no contrast, the least and the
//           greatest value. A file of ours tells its range itself. Padding (the file's own and findPadding) becomes 0, whatever its value, and so
//           do NaN and infinity. Colour becomes its luminance (Rec. 709 weights on the coded values, so that grey stays as it
//           is).
//   cost    O(voxels); percentiles from at most 4 million voxels, evenly chosen
//   errors  Cancelled
NormalisedVolume normalise(const StoredVolume& stored, const std::vector<std::uint8_t>& numbers,
                           const Progress& progress = {}, bool outside = true);

}  // namespace sonoskin
