#pragma once

#include "core/base/progress.h"
#include "core/classification/classification_options.h"
#include "core/classification/iso_value.h"
#include "core/volume/volume.h"

namespace sonoskin {

// Smoothed: what classification needs of a volume and of the low-pass options alone; kept while sliders move.
struct Smoothed {
  Volume<float> lowPassed;
  GreyLevels levels{};  // for options whose iso-value is automatic
};

// smooth: the low-passed volume.
//   volume   values in [0, 1], at least 3 voxels along each axis
//   errors   Error: too few voxels; Cancelled
Smoothed smooth(const Volume<float>& volume, const ClassificationOptions& options,
                const Progress& progress = {});

}  // namespace sonoskin
