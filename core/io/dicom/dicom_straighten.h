#pragma once

#include "core/base/progress.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// straightened: the dimensions of the straight grid that holds all slices of a volume, each of which lies further across the
// one before.
//   input   shift  from slice to slice, along rows and columns, mm
glm::ivec3 straightened(const Geometry& geometry, const glm::dvec2& shift);

// straighten: puts the slices of a volume where they are, onto a straight grid of the same spacing, with linear weights
// within each slice; where none of them reaches there is no number.
//   input   loaded  one number per voxel, or colours; its geometry as if the slices lay straight above each other
//   output  float; 8-bit numbers keep their type's range
//   errors  Cancelled
void straighten(LoadedVolume& loaded, const glm::dvec2& shift, const Progress& progress);

}  // namespace sonoskin
