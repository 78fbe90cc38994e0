#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/io/read_options.h"
#include "core/io/stored_volume.h"

// Toshiba's RawDataExport (Aplio): RawData_VolN.bin, bytes without a header, and one PatientInfo.txt with the geometry of all.
// Known from one program that reads them (MaxandreJ/Ultrasound_4D_Images_Analyser) and the sizes of the numbers.
namespace sonoskin {

// isToshiba: whether a path is a RawData_Vol*.bin with a PatientInfo.txt beside it, that text, or a folder with both.
bool isToshiba(const std::filesystem::path& path);

// readToshiba: the samples, with their grid in stored.grid.
//   path     one of the files: that one; the text or the folder: all files in the order of their numbers, as time steps
//   errors   Error: the geometry is missing or cannot be, the file has another size, there is no such time step
// What two fields of the text mean is not certain; what is assumed is said by the log. Of the text nothing is kept but its
// geometry.
LoadedVolume readToshiba(const std::filesystem::path& path, const ReadOptions& options,
                         const Progress& progress = {});

}  // namespace sonoskin
