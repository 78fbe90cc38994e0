#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// trianglesWithin: per triangle 1 where it lies within `reach` mm of a marked one, through space; so do some that are up to
// half as far again away, or, if they are larger than that, their own size.
//   cost     350,000 triangles: 0.01 s
std::vector<std::uint8_t> trianglesWithin(const Mesh& mesh, const std::vector<std::uint8_t>& isMarked,
                                          float reach);

// selectTriangles: a mesh of some triangles in their order, with the vertices that they use in the order of first use.
Mesh selectTriangles(const Mesh& mesh, const std::vector<std::uint32_t>& triangles);

}  // namespace sonoskin
