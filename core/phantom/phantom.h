#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/phantom/body_part.h"
#include "core/phantom/phantom_options.h"
#include "core/volume/scan.h"

namespace sonoskin {

// makePhantomScan: a simulated 3D ultrasound scan of a sleeping newborn; in `clear` one hand is near the mouth.
//   output   8-bit grey (stored as multiples of 1/255), 0 outside the sector, with the beam's geometry; probe
//            at j = 0, head toward -i
//   contrast of `clear`: CNR = (mean grey of skin - of fluid) / sqrt(mean of their variances) at the default
//            size; skin: the 0.9 mm below the surface where it faces the beam (cosine > 0.7); fluid: 3 mm clear of
//            everything, less than 35 mm deep.   snr  0: 2.4   10: 4.2   20: 6.2   30: 7.7   40: 7.7
//   errors   Error: an option is out of range; Cancelled
//   threads  the result does not depend on their number
//   scenes   what else makes it hard, and which head it is: PhantomOptions, assets/docs/phantom.md
//   cost     3 s of one core and 180 MB at the default size; 0.6 s at 256 x 144 x 72
Scan makePhantomScan(const PhantomOptions& options, const Progress& progress = {});

// makePhantomTruth: the skin that the scan shows, in the scan's frame.
//   output   closed mesh (flat where the baby leaves the field of view) with exact normals, vertices within
//            0.02 mm of the true skin; visibility 1 where the simulated probe sees the skin: at least 1 mm
//            inside the sector and the field of view, the cosine between normal and way back to the probe
//            above 0.25, none of the baby and no cord in between, no other tissue within 0.8 mm (but for the
//            first phantom), and less than 8 dB lost (there and back) in the mother's tissue and at grazed
//            edges; 0 elsewhere. labels: the BodyPart, never `other`: tissue that is not the baby's is not in
//            the mesh (PhantomModel knows it)
//   errors   Error: an option is out of range; Cancelled
//   cost     1.4 s of one core
Mesh makePhantomTruth(const PhantomOptions& options, const Progress& progress = {});

}  // namespace sonoskin
