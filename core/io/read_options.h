#pragma once

#include "core/io/raw_options.h"
#include "core/volume/scan_options.h"

namespace sonoskin {

// ReadOptions: what is read of a file, and how.
//   volume  which of several volumes, counted from 1 as listVolumes does; 0: there must be one alone
//   time    which of its time steps, counted from 1
//   voxel   mm, the edge of voxels that samples of a probe's beams are converted to; 0: chosen (core/volume/scan_convert.h)
//   raw     what a file without a header does not tell
//   regionOnly  blanks what lies outside of the picture in ultrasound of DICOM
struct ReadOptions {
  int volume = 0;
  int time = 1;
  double voxel = 0;
  RawOptions raw{};
  bool regionOnly = false;
};

inline ReadOptions readOptions(const ScanOptions& scan, const RawOptions& raw) {
  return {scan.volume, scan.time, scan.voxel, raw, scan.regionOnly};
}

}  // namespace sonoskin
