#pragma once

#include "core/volume/scan.h"

namespace sonoskin {

// mirrorScan: turns one axis of a scan over in the world, about the middle of the volume: for a file whose left and right come
// out swapped. Voxels keep their indices; the frame of their axes becomes the other-handed one, with the beam.
//   output  another key; nothing for MirroredAxis::none
void mirrorScan(Scan& scan, MirroredAxis axis);

}  // namespace sonoskin
