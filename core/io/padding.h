#pragma once

#include <optional>

#include "core/volume/volume.h"

namespace sonoskin {

// Padding: the values that a file has where nothing was recorded, least to most.
struct Padding {
  float least = 0, most = 0;
  bool holds(float value) const { return value >= least && value <= most; }
};

// findPadding: a background that is constant or nearly so and touches the sides of the volume, whatever its value: 0,
// -1024, DICOM's PixelPaddingValue, 255, or the noise of a lossy picture.
//   method  most of the voxels on the volume's six sides have one value, or lie within a fiftieth of the range of
//           all: then those values are padding. Not finite ones are left to the caller; where hardly any others lie on
//           the sides, these mark the outside already.
//   output  nothing where there is none: a volume that was recorded up to its sides, or is constant
std::optional<Padding> findPadding(const Volume<float>& volume);

}  // namespace sonoskin
