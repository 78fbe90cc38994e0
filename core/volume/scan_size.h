#pragma once

#include "core/base/progress.h"
#include "core/volume/scan.h"

namespace sonoskin {

// kBytesPerVoxel: what a voxel takes of memory on the way from a file to a mesh and its pictures, at most; measured for
// volumes of 15 to 540 million voxels. kBytesToRead: of that, what reading takes.
inline constexpr double kBytesPerVoxel = 20, kBytesToRead = 4;

// reduceScan: what the options leave of a scan when it is read: a box, and voxels of twice the size.
//   output  another key where something was left out
//   errors  Error: nothing is left; Cancelled
void reduceScan(Scan& scan, const ScanOptions& options, const Progress& progress = {});

// requireMemory: refuses a volume for which there is not enough memory, before it is taken.
//   bytesPerVoxel  that are still to be taken
//   available      bytes; as availableMemory() tells
//   errors         Error: says how much there is, how much it takes, and which options make it less
void requireMemory(const Geometry& geometry, double bytesPerVoxel, std::size_t available);

}  // namespace sonoskin
