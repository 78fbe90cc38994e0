#pragma once

#include <cstdint>
#include <vector>

#include "core/volume/volume.h"

namespace sonoskin {

// VoxelRun: voxels one after the other in memory.
struct VoxelRun {
  std::size_t first = 0, count = 0;
};
using VoxelRuns = std::vector<VoxelRun>;

// append: adds a voxel to the runs; the last run grows where the voxel follows it.
void append(VoxelRuns& runs, std::size_t voxel);

// Brush: a ball that is moved along a straight line. World mm.
//   radius  > 0; the voxel nearest to `to` is always part of it
//   mark    what the voxels become: erased, or brought back
struct Brush {
  glm::dvec3 from{0}, to{0};
  double radius = 5;
  bool mark = true;
};

// paint: marks the voxels whose centres lie within the radius of the line.
//   mask    not zero: marked
//   output  the voxels that changed, each once; a brush beside the volume changes none
//   cost    the voxels of the line's box
VoxelRuns paint(Volume<std::uint8_t>& mask, const Brush& brush);

// toggle: marked voxels of the runs are cleared, the others marked: what undoes a stroke, and does it again.
void toggle(Volume<std::uint8_t>& mask, const VoxelRuns& runs);

// differences: the voxels that are marked in one of two masks of the same dimensions alone.
VoxelRuns differences(const Volume<std::uint8_t>& a, const Volume<std::uint8_t>& b);

// RunLengths: a mask as the lengths of its runs in memory order: not marked, marked, not marked, and so on; the first may
// be 0. The lengths together are the voxels.
struct RunLengths {
  glm::ivec3 dims{0};
  std::vector<std::size_t> counts;
};
RunLengths runLengths(const Volume<std::uint8_t>& mask);
// fromRunLengths: the mask again.
//   errors  Error: the volume has other dimensions, or the lengths do not fill it
Volume<std::uint8_t> fromRunLengths(const RunLengths& runs, const Geometry& geometry);

}  // namespace sonoskin
