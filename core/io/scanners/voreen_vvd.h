#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/io/read_options.h"
#include "core/io/stored_volume.h"
#include "core/io/volume_entry.h"

// Volumes of Voreen 3 and later: an XML .vvd that names raw files beside it.
namespace sonoskin {

// readVoreenVvd: one of its volumes.
//   output  origin, spacing and a Transformation of its metadata, mm; Voreen's world is taken for LPS
//   errors  Error: it is no such XML, holds several volumes of which none was chosen, its raw file lies elsewhere or has another
//           size, numbers of a format that is not known here
LoadedVolume readVoreenVvd(const std::filesystem::path& path, const ReadOptions& options,
                           const Progress& progress = {});

// vvdVolumes: where it holds several, what they are; else nothing.
std::vector<VolumeEntry> vvdVolumes(const std::filesystem::path& path);

}  // namespace sonoskin
