#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/phantom/phantom_options.h"
#include "core/volume/scan.h"

namespace sonoskin {

// makePhantomScan: a simulated 3D ultrasound scan of a sleeping newborn with one hand near the mouth.
//   output   8-bit grey (stored as multiples of 1/255), the beam's geometry included; probe at j = 0, head
//   toward -i errors   Error: an option is out of range; Cancelled threads  the result does not depend on
//   their number
Scan makePhantomScan(const PhantomOptions& options, const Progress& progress = {});

// makePhantomTruth: the skin that the scan shows, in the scan's frame.
//   output   closed mesh with normals; visibility 1 where the simulated probe sees the skin (inside the field
//   of
//            view, facing the beam, not in a shadow), 0 where not
Mesh makePhantomTruth(const PhantomOptions& options, const Progress& progress = {});

}  // namespace sonoskin
