#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/progress.h"
#include "core/io/declared_data.h"
#include "core/io/file_formats.h"
#include "core/io/stored_volume.h"

namespace itk {
class ImageIOBase;
}

// Volumes in one file (NRRD, MetaImage, NIfTI, VTK), read and written by ITK. No other file sees it.
namespace sonoskin {

// readWithItk: reads a file that checkData has let through.
//   unpacked what checkData gave: its numbers, or nothing
//   time     which time step, counted from 1
//   output   numbers of that time step after the file's slope and intercept; the geometry in mm and LPS
//   errors   Error: ITK cannot read it, or takes it for something else than its header declares; there is no such
//            time step; Cancelled
//   cost     the memory of all time steps
LoadedVolume readWithItk(FileFormat format, const std::filesystem::path& path, const DeclaredData& data,
                         std::vector<std::uint8_t> unpacked, int time, const Progress& progress = {});

// writeWithItk: writes one number per voxel, atomically; packed, where the format can.
//   input    stored   of the type uint8 or float32; NRRD and MetaImage keep its beam and its range
//            numbers  as many as the geometry has voxels
//   errors   Error (system): the file cannot be written; Cancelled
void writeWithItk(FileFormat format, const std::filesystem::path& path, const StoredVolume& stored,
                  const void* numbers, const Progress& progress = {});

// describedBy: what an image that ITK has opened is: its geometry, type and numbers per voxel.
//   errors   Error: numbers of a type that is not known here
StoredVolume describedBy(const itk::ImageIOBase& io, const std::filesystem::path& path);

// callItk: calls ITK, whose own words may quote the file, so that they are not passed on.
//   errors   Error: `sentence`, where it fails; std::bad_alloc
void callItk(const std::function<void()>& call, const std::string& sentence);

}  // namespace sonoskin
