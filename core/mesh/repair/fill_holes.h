#pragma once

#include <limits>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// HoleOptions: which borders are holes.
//   largest    size across: the greatest distance between two points of the border, mm
//   outline    what becomes of the largest border of every piece: filled as any other; kept open, however small it is;
//              or kept open unless it is small beside its piece (the squared diagonal of its box below a tenth of
//              the area: a disc has 2.5 times its area, a tube three times as long as wide 0.2, a sphere with a hole of
//              a third of its width 0.07)
//   crossing   whether a hole is filled too whose patch would cross the surface or another patch; else it stays open
enum class Outline { fill, keep, keepUnlessSmall };
struct HoleOptions {
  double largest = std::numeric_limits<double>::infinity();
  Outline outline = Outline::fill;
  bool crossing = true;
};

// fillHoles: fills holes with triangles of the size of those around them, going on smoothly from the surface.
//   input    triangles all turned the same way; where surfaces touch in a point they come apart
//   output   the vertices and triangles of the mesh first, as they were; new vertices get normals, visibility,
//            measured and label 0 where the mesh has them. No edge comes to belong to more than two triangles.
//   method   triangulation, refinement and fairing [Liepa 2003]; see hole_triangulation.h and its neighbours
//   cost     a hole of 100 points 20 ms, of 1000 points 1 s
//   errors   Cancelled
Mesh fillHoles(const Mesh& mesh, const HoleOptions& options, const Progress& progress = {});

}  // namespace sonoskin
