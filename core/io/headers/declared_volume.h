#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/io/file_formats.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// readDeclared: reads a volume in one file, or in the few that its header names: NRRD, MetaImage, NIfTI, VTK
// legacy.
//   time    which time step, counted from 1
//   output  the geometry that the header states, in mm and LPS, as checkGeometry() leaves it
//   errors  Error: as the header's reader, checkGeometry() and readNumbers(); there is no such time step;
//           pictures that no tracker has placed; Cancelled
// Pictures that a tracker has placed are reconstructed to a volume (core/volume/sweep.h).
LoadedVolume readDeclared(FileFormat format, const std::filesystem::path& path, int time,
                          const Progress& progress = {});

}  // namespace sonoskin
