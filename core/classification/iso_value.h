#pragma once

#include "core/volume/field_of_view.h"
#include "core/volume/volume.h"

namespace sonoskin {

// proposeIsoValue: a grey value at the border of the skin: part of the way from the fluid's to the tissue's.
//   lowPassed  values in [0, 1]
//   view       voxels outside it are not counted
//   method     Otsu's threshold parts the histogram into fluid and tissue; the proposal lies kShare of the
//              way from the one's mean to the other's  [Otsu 1979; the share from the spec's 0.35 .. 0.42]
//   output     in [0.02, 0.98]
float proposeIsoValue(const Volume<float>& lowPassed, const FieldOfView& view);

}  // namespace sonoskin
