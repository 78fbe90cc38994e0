#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/progress.h"
#include "core/io/read_options.h"
#include "core/io/stored_volume.h"
#include "core/io/volume_entry.h"

namespace sonoskin {

// isDicom: whether a file begins as DICOM files do.
//   errors  as readBytes
bool isDicom(const std::filesystem::path& path);

// readDicomSeries: reads a volume of DICOM: slices of a series, frames of a file, or what its maker has made of it.
//   input   path  a folder or a DICOMDIR, with one volume or the one that the options choose; or a file: the volume that it is
//                 part of
//   output  numbers after the file's rescale slope and intercept, colours as red, green and blue. The geometry is that of the
//           frames' own places and directions, in mm and LPS. Slices that lie across each other by the same distance, as those
//           of a tilted gantry do, are put onto a straight grid, which the log tells.
//   errors  Error: no volume, several of them and none chosen; slices that make no volume (core/io/dicom/dicom_stacks.h); a film; an
//           element that is longer than its file; pixels that are missing, or packed in an unknown way; what only its maker's
//           programs read; Cancelled
// Only elements of a list are taken from a file (core/io/dicom/dicom_tags.h); none of its text is kept or shown.
LoadedVolume readDicomSeries(const std::filesystem::path& path, const ReadOptions& options = {},
                             const Progress& progress = {});

// dicomVolumes: the volumes of a file or folder that holds several, in the order in which ReadOptions count them; empty
// where there is one alone.
//   errors  as readDicomSeries, for what the headers tell; Cancelled
std::vector<VolumeEntry> dicomVolumes(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
