#pragma once

#include "core/volume/scan_options.h"

namespace sonoskin {

// ReadOptions: what is read of a file that holds more than one volume.
//   volume  which of several volumes, counted from 1 as listVolumes does; 0: there must be one alone
//   time    which of its time steps, counted from 1
struct ReadOptions {
  int volume = 0;
  int time = 1;
};

inline ReadOptions readOptions(const ScanOptions& scan) { return {scan.volume, scan.time}; }

}  // namespace sonoskin
