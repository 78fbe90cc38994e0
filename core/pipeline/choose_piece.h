#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "core/mesh/mesh_options.h"
#include "core/volume/scan.h"

namespace sonoskin {

// choosePiece: the piece of the surface that the options ask for, or several as one mesh.
//   pieces   largest area first (splitPieces)
//   middle   a point on the middle beam, such as the centre of the volume, mm
//   errors   Error: no pieces; options.pieceIndex is beyond them
Mesh choosePiece(const std::vector<Mesh>& pieces, const MeshOptions& options, const Beam& beam,
                 const glm::dvec3& middle);

}  // namespace sonoskin
