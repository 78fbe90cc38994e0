#pragma once

#include "core/base/progress.h"
#include "core/surface/surface_points.h"
#include "core/volume/volume.h"

namespace sonoskin {

// echoOffset: how far outside the skin the points lie, because an echo is thick.
//   points   on the outer flank of the echo, normals outward
//   volume   the recorded one, not low-passed
//   output   mm, along the normals; 0 where the echo does not rise behind the points
//   method   The grey along the normals, averaged over the points, is low outside and rises to the first maximum
//            inside. The skin is taken to lie where the grey has risen by kSkinRise of the way: the echo of an
//            interface starts before it, by the length of the pulse and the width of the beam, and log compression
//            and the low-pass that the points come from widen it further. The offset is measured in the volume at
//            hand, so that it follows the probe, the iso-value, the low-pass and the noise; only the share is
//            calibrated. 8 voxels outward and inward are looked at.
//   errors   Cancelled
double echoOffset(const SurfacePoints& points, const Volume<float>& volume, const Progress& progress = {});

// moveInward: moves every point by that many mm against its normal.
void moveInward(SurfacePoints& points, double mm);

}  // namespace sonoskin
