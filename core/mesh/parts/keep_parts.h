#pragma once

#include "core/mesh/parts/choose_parts.h"

namespace sonoskin {

// keepParts: the part of a surface that is kept, cut off along smooth lines.
//   verdicts   one per part
//   method     +1 on what is kept and -1 on the rest, smoothed along the surface within some 4 mm of the cut, and clipped
//              where that is zero, so that no triangle's or patch's outline is seen; other borders stay
//   output     empty if nothing is kept
//   errors     Cancelled
Mesh keepParts(const Mesh& mesh, const SurfaceParts& parts, const std::vector<PartVerdict>& verdicts,
               const Progress& progress = {});

}  // namespace sonoskin
