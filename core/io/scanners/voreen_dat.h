#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/io/read_options.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// readVoreenDat: a volume of Voreen, Inviwo or QVis: a text .dat that names a raw file beside it (ObjectFileName, Resolution,
// SliceThickness in mm, Format, ObjectModel, NumFrames, ByteOrder).
//   errors   Error: a key that is needed is missing or not known here, the raw file lies elsewhere or has another size
LoadedVolume readVoreenDat(const std::filesystem::path& path, const ReadOptions& options,
                           const Progress& progress = {});

}  // namespace sonoskin
