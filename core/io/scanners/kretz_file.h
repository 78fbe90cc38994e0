#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/io/read_options.h"
#include "core/io/stored_volume.h"
#include "core/io/volume_entry.h"

// GE Kretz files (KRETZFILE 1.0), toroidal or Cartesian. None of this was ever checked against a file from a GE machine: it
// follows open readers (plooney/kretz, SlicerHeart).
namespace sonoskin {

// kretzVolume: one volume of a file that lies in memory, as it also does inside of a DICOM file.
//   options  volume: as kretzVolumes counts them; 0: the grey one
//   output   8 or 16 bit, of the time step that was asked for. Of a toroidal file the samples, with their grid in
//            stored.grid and no place in the world yet. The beam's radius, angles and distances are those of SlicerHeart
//            (angles count from a right angle). `bytes` is left to the caller.
//   errors   Error: another version, cut off, packed by wavelets (says how to save it unpacked), sizes that contradict each
//            other, a grid that cannot be one, a volume or time step that it does not have
// Says by the log what is assumed. Names, dates, places and machines are never read.
LoadedVolume kretzVolume(std::span<const std::uint8_t> file, const ReadOptions& options,
                         const std::filesystem::path& path);

// kretzVolumes: the volumes of a file: grey, colour flow, power Doppler; empty where it holds one alone.
//   errors   as kretzVolume
std::vector<VolumeEntry> kretzVolumes(std::span<const std::uint8_t> file, const std::filesystem::path& path);

// kretzEntry: the volume that is read of a file where none is chosen, by its records alone: of a file that is mapped into memory
// the voxels stay on the disk.
//   errors   as kretzVolume, but for a grid that cannot be one
VolumeEntry kretzEntry(std::span<const std::uint8_t> file, const std::filesystem::path& path);

// readKretzFile: kretzVolume of a file on disk.
LoadedVolume readKretzFile(const std::filesystem::path& path, const ReadOptions& options,
                           const Progress& progress = {});

}  // namespace sonoskin
