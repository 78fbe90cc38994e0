#pragma once

#include <array>
#include <cstddef>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// Corners: of one triangle.
using Corners = std::array<glm::dvec3, 3>;

// trianglesCross: whether a side of one triangle passes through the other. Triangles that lie in one plane do not
// cross; neighbours, which have a corner (by position) in common, only where they meet elsewhere too; those with a
// common side never.
//   method  signs of tetrahedra's volumes in double; what lies within the rounding counts as touching
bool trianglesCross(const Corners& a, const Corners& b);

// countSelfIntersections: the number of pairs of triangles that cross.
//   method   boxes in a tree, then trianglesCross
//   cost     1 million triangles: 2 s on one core
//   threads  the result does not depend on their number
//   errors   Cancelled
std::size_t countSelfIntersections(const Mesh& mesh, const Progress& progress = {});

}  // namespace sonoskin
