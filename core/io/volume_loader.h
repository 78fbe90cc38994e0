#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// loadVolume: reads a volume as it lies in its file or series, with ITK and GDCM, in this process.
//   errors  as readScan
LoadedVolume loadVolume(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
