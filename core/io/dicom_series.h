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

// readDicomSeries: reads the slices of a series, sorted by their positions along their common normal.
//   input   path  a folder: its largest series; a file: the series that it belongs to, or its own frames
//   output  numbers after the file's rescale slope and intercept; spacing along k is the distance between positions
//   errors  Error: no series, slices of different sizes, missing slices (distances that differ by a tenth), an element
//           that is longer than its file, a file that holds no pixels or needs the maker's own reader; Cancelled
// No text element is kept.
LoadedVolume readDicomSeries(const std::filesystem::path& path, const ReadOptions& options = {},
                             const Progress& progress = {});

// dicomVolumes: the volumes of a file or folder that holds several, in the order in which ReadOptions count them; empty
// where there is one alone.
//   errors  as readDicomSeries, for what the headers tell; Cancelled
std::vector<VolumeEntry> dicomVolumes(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
