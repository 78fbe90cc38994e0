#pragma once

#include "core/base/progress.h"
#include "core/io/dicom/dicom_collector.h"
#include "core/io/read_options.h"

namespace sonoskin {

// commonRegion: the box around where in their frames the pictures lie, of those that tell; nothing where none does.
std::optional<DicomRegion> commonRegion(const DicomFiles& files, const DicomVolume& volume);

// readDicomVolume: the numbers of one time step of a volume whose frames are known, slice by slice as they lie in their files.
//   input   volume  one with frames and without a refusal; options: a time step that it has
//   output  with options.regionOnly each frame is blanked outside of its own region, or of the common one where it tells none
//   errors  Error: slices of different meanings; files that cannot be read, or pixels that cannot be unpacked; no volume
//           (checkGeometry). Cancelled between frames
LoadedVolume readDicomVolume(const DicomFiles& files, const DicomVolume& volume, const ReadOptions& options,
                             const Progress& progress, const std::filesystem::path& path);

}  // namespace sonoskin
