#pragma once

#include "core/base/progress.h"
#include "core/io/dicom/dicom_collector.h"

namespace sonoskin {

// dicomFiles: reads the headers of a file with those of its series beside it, of all files in a folder, or of those that a
// DICOMDIR names.
//   output  the volumes of the file that was chosen, or all; pictures that are no volume are left out where there are volumes
//   errors  Error: nothing in it can be read, with the first reason; more than 50,000 files; Cancelled between files
// A DICOMDIR that is damaged, or none of whose files are there, stands for what lies beside it, with a warning.
// Files of a folder that are damaged are left out with a warning of how many there are: their names may be a patient's.
DicomFiles dicomFiles(const std::filesystem::path& path, const Progress& progress);

// dicomDirectory: the list of files that was chosen itself or lies in the folder that was; empty where there is none. It is
// known by the name that the standard gives it [DICOM PS3.10, 8.6].
std::filesystem::path dicomDirectory(const std::filesystem::path& path);

}  // namespace sonoskin
