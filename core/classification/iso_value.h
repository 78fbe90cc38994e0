#pragma once

#include "core/volume/field_of_view.h"
#include "core/volume/volume.h"

namespace sonoskin {

// GreyLevels: what a volume's greys tell of the skin, in [0.02, 0.98].
//   isoValue  at the border of the skin, as low as the fluid's noise allows: for the classification
//   visible   farther up the skin's edge, clear of the fluid's noise: for views of the volume itself
struct GreyLevels {
  float isoValue = 0.3f, visible = 0.3f;
};

// proposeLevels: both levels, from the volume.
//   lowPassed  values in [0, 1]
//   view       voxels outside it, and those within 6 voxels of its sides, are not counted
//   beam       edges count that go from dark to bright along it, as skin in fluid does
//   method     e: the mean grey on the steepest edges, weighted by their gradient  [Katz 1965], which does not
//              depend on how much of the volume is fluid; f: the mean grey of everything darker than e, that is
//              the fluid and the shadows; the levels are f + 0.2 (e - f) and f + 0.6 (e - f). The 0.2 is ours,
//              from simulated scans at five noise levels: more lets the fluid's speckle in, less loses skin.
//   cost       looks at 230,000 voxels, evenly spread: 20 ms
GreyLevels proposeLevels(const Volume<float>& lowPassed, const FieldOfView& view, const Beam& beam);

}  // namespace sonoskin
