#pragma once

#include "core/base/progress.h"
#include "core/enhancement/enhancement_options.h"
#include "core/volume/volume.h"

namespace sonoskin {

// diffuse: the volume with less speckle: smoothed where it is flat, hardly across edges. Log compression has turned
// the multiplicative noise of the echoes into an additive one, for which this is the plain form of speckle reducing
// diffusion.
//   volume   values in [0, 1]
//   options  iterations n and conductance kappa; the method is not looked at
//   solves   du/dt = div(c grad u), c = 1 / (1 + |grad u|^2 / (kappa m)^2), m: the median gradient of the voxels
//            that are not 0, taken again at every step; nothing flows through the volume's border
//            [Perona, Malik 1990, eq. 3 and its second conductance; the median is ours]
//   method   explicit steps of 0.9 of the longest stable one; gradients per smallest spacing by central differences;
//            the conductance between two voxels is the mean of theirs
//   output   within the least and greatest value of the volume, of the same mean
//   cost     per step 12 bytes and 40 operations per voxel; 467x255x124: 0.1 s of one core. 8 bytes per voxel.
//   errors   Cancelled
Volume<float> diffuse(const Volume<float>& volume, const EnhancementOptions& options,
                      const Progress& progress = {});

}  // namespace sonoskin
