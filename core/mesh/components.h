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

// viewShares: how much of the probe's view each piece fills, as a share of what the best piece fills.
//   middle   a point on the middle beam, such as the centre of the volume, mm
//   method   depth buffer of 256 x 256 beams: by angle around an apex, by place for parallel beams. Each beam gives
//            the piece that it meets first the weight exp(-ρ²/(2 · 0.35²)), ρ: distance from the middle beam in
//            halves of the larger extent of all pieces. So a face wins against a larger wall behind or beside it,
//            against what lies inside it, and against specks in front.
//   output   0 to 1, one per piece; the best has 1
std::vector<double> viewShares(const std::vector<Mesh>& pieces, const Beam& beam, const glm::dvec3& middle);

}  // namespace sonoskin
