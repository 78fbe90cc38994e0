#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/vertex_rings.h"

namespace sonoskin {

// smoothAlong: smooths values at the vertices of a mesh along its surface; those beyond ±limit stay.
//   rings    of the mesh
//   values   one per vertex
//   steps    each replaces a value by the mean of itself and its neighbours' mean; n steps spread it over about
//            sqrt(n/2) edges
//   cost     O(steps · vertices within the limit)
//   errors   Cancelled
std::vector<float> smoothAlong(const VertexRings& rings, std::vector<float> values, float limit, int steps,
                               const Progress& progress = {});

// clipMesh: the part of a mesh where values at its vertices are > 0, cut through triangles on the line where they are 0.
//   values   one per vertex
//   output   vertices that no triangle uses are gone; normals, visibility and measured are kept, and interpolated at the cut,
//            labels too, there that of the vertex that stays; a manifold mesh stays one. Cuts keep a twentieth of an edge's length from its ends
Mesh clipMesh(const Mesh& mesh, const std::vector<float>& values);

}  // namespace sonoskin
