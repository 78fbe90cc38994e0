#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/io/file_formats.h"
#include "core/io/stored_volume.h"

// Volumes in one file (NRRD, MetaImage, NIfTI, VTK), written by ITK. No other file sees it.
namespace sonoskin {

// writeWithItk: writes one number per voxel, atomically; packed, where the format can.
//   input    stored   of the type uint8 or float32; NRRD and MetaImage keep its beam and its range
//            numbers  as many as the geometry has voxels
//   errors   Error (system): the file cannot be written; Cancelled
void writeWithItk(FileFormat format, const std::filesystem::path& path, const StoredVolume& stored,
                  const void* numbers, const Progress& progress = {});

}  // namespace sonoskin
