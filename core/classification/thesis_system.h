#pragma once

#include "core/base/progress.h"
#include "core/classification/classification_options.h"
#include "core/volume/volume.h"

namespace sonoskin {

// classifyThesis: u as the thesis computes it, for the formulations thesis-closed and thesis-skew.
//   solves     (alpha a + gamma h) u + c . grad u = gamma h uind, a row of equation 3.7, with
//              a = (w (v - viso)^2 + (1 - w)(v~ - viso)^2) / (|grad v|^2 + FLT_EPSILON)
//              h = delta + (1 - delta) |grad v|
//              c = beta grad v~ x curl grad v~
//   its ways   v~ is the mean of 3x3x3 voxels; gradients are central differences per voxel, whatever the spacing,
//              and 0 in the outermost layer of voxels
//   closed     the curl of a gradient is zero, so that u = gamma h uind / (alpha a + gamma h)
//   skew       the curl as options.curl takes it; solved by sweeps (skew_system.h)
//   rescale    u is brought to [0, 1] by its least and greatest value; without it u is clamped to [0, uind]
//   volume     values in [0, 1], at least 3 voxels along each axis
//   options    isoValue must be above 0; unusedBecause() in parameter_use.h tells which others count
//   output     0 where an equation says 0/0
//   cost       closed: 12 bytes of traffic per voxel, 20 with rescale
//   errors     Error: too few voxels; the skew system cannot be solved by sweeps; Cancelled
Volume<float> classifyThesis(const Volume<float>& volume, const ClassificationOptions& options,
                             const Progress& progress = {});

// ThesisRow: numerator and denominator of the closed form for the voxels of a row, both times |grad v|^2 + eps,
// which keeps them finite where v is flat.
//   diagonal  alpha (w (v - viso)^2 + (1 - w)(v~ - viso)^2) + gamma h (|grad v|^2 + eps)
//   right     gamma h uind (|grad v|^2 + eps)
//   edge      |grad v|^2 + eps
struct ThesisRow {
  float *diagonal, *right, *edge;
};

// thesisRow: fills `out`, dims.x values each, from a row of v and of v~.
void thesisRow(const Volume<float>& volume, const float* lowPassed, int j, int k,
               const ClassificationOptions& options, const ThesisRow& out);

}  // namespace sonoskin
