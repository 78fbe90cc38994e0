#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/io/read_options.h"
#include "core/io/stored_volume.h"
#include "core/io/volume_entry.h"

namespace sonoskin {

// loadVolume: reads a volume as it lies in its file or series, with ITK and GDCM, in this process.
//   errors  as readScan
LoadedVolume loadVolume(const std::filesystem::path& path, const ReadOptions& options = {},
                        const Progress& progress = {});

// volumesIn: the volumes of a file or folder that holds several; empty where there is nothing to choose.
//   errors  as readScan, for what can be told without the voxels
std::vector<VolumeEntry> volumesIn(const std::filesystem::path& path, const ReadOptions& options = {},
                                   const Progress& progress = {});

}  // namespace sonoskin
