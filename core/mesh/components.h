#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/volume/scan.h"

namespace sonoskin {

// splitPieces: the connected pieces of a mesh, joined by common vertices.
//   output   largest area first; equal areas in the order of their triangles; normals, visibility, measured, labels and
//            texture coordinates are kept
//   cost     O(n); 1 million triangles in 0.1 s
//   errors   Cancelled
std::vector<Mesh> splitPieces(const Mesh& mesh, const Progress& progress = {});

// pieceOfVertices: for every vertex the number of its piece in the order of splitPieces; 0xffffffff without a triangle.
std::vector<std::uint32_t> pieceOfVertices(const Mesh& mesh);

// joinPieces: one mesh of all pieces. What vertices have is kept where every piece has it.
Mesh joinPieces(const std::vector<Mesh>& pieces);

// pieceNearest: the piece with the triangle nearest to a point.
//   errors   Error: there is no piece
std::size_t pieceNearest(const std::vector<Mesh>& pieces, const glm::vec3& point);

// viewShares: how much of the probe's view each piece fills, as a share of what the best piece fills; see view_shares.h.
std::vector<double> viewShares(const std::vector<Mesh>& pieces, const Beam& beam, const glm::dvec3& middle);

}  // namespace sonoskin
