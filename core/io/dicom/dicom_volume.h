#pragma once

#include "core/base/progress.h"
#include "core/io/dicom/dicom_collector.h"
#include "core/io/read_options.h"

namespace sonoskin {

// readDicomVolume: the numbers of one time step of a volume whose frames are known, slice by slice as they lie in their files.
//   input   volume  one with frames and without a refusal; options: a time step that it has
//   errors  Error: slices of different meanings; files that cannot be read, or pixels that cannot be unpacked; no volume
//           (checkGeometry). Cancelled between frames
LoadedVolume readDicomVolume(const DicomFiles& files, const DicomVolume& volume, const ReadOptions& options,
                             const Progress& progress, const std::filesystem::path& path);

}  // namespace sonoskin
