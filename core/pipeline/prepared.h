#pragma once

#include "core/classification/classify.h"
#include "core/classification/iso_value.h"
#include "core/pipeline/parameters.h"
#include "core/volume/field_of_view.h"
#include "core/volume/scan.h"

namespace sonoskin {

// Prepared: everything that classification needs of the volume itself.
struct Prepared {
  Smoothed smoothed;
  FieldOfView view;
  Beam beam;
};

// prepare: from the volume that is classified, the scan's own or the enhanced one.
//   errors   Error: see smooth and beamWithin; Cancelled
Prepared prepare(const Scan& scan, const Volume<float>& input, const Parameters& parameters,
                 const Progress& progress = {});

}  // namespace sonoskin
