#pragma once

#include "core/base/progress.h"
#include "core/io/read_options.h"
#include "core/io/stored_volume.h"
#include "core/volume/scan.h"

namespace sonoskin {

// LoadedScan: a scan, and what its file's values were.
//   valueMin, valueMax  least and greatest finite one of the time step that was read
struct LoadedScan {
  Scan scan;
  double valueMin = 0, valueMax = 0;
};

// scanOf: makes a scan of what was read from a file: intensities in [0, 1], on voxels.
//   isScan   false for marks, whose sides may all be marked
//   output   samples of a probe's grid are converted to voxels on all threads, with the mask of what was scanned and the beam
//            that the grid tells, but for a pyramid's; what is said of that goes to the log. A mask that was read is kept
//   memory   the file's numbers are given back before voxels are taken, samples before this returns
//   errors   Error: too little memory for so many voxels; Cancelled
LoadedScan scanOf(LoadedVolume loaded, const ReadOptions& options, bool isScan,
                  const Progress& progress = {});

}  // namespace sonoskin
