#pragma once

#include "core/mesh/mesh_options.h"
#include "core/mesh/parts/choose_parts.h"

namespace sonoskin {

// PartedSurface: all pieces of a surface as one mesh, and its parts.
struct PartedSurface {
  Mesh mesh;
  SurfaceParts parts;
};

// KeptParts: what is kept of a surface, as one mesh, and why; no verdicts where whole pieces were chosen.
struct KeptParts {
  Mesh mesh;
  std::vector<PartVerdict> verdicts;
};

// partSurface: the parts of a surface, with those split that the options' strokes cross, in their order.
//   pieces   largest area first (splitPieces)
//   errors   Error: there are no pieces; Cancelled
PartedSurface partSurface(const std::vector<Mesh>& pieces, const MeshOptions& options,
                          const Progress& progress = {});

// keepAsAsked: the parts that the options ask for: chooseParts or all, then those at partsAdd, then without those at
// partsDrop.
//   errors   Error: every part is taken away; Cancelled
KeptParts keepAsAsked(const PartedSurface& surface, const MeshOptions& options, const PartView& view,
                      const Progress& progress = {});

}  // namespace sonoskin
