#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// seenTriangles: per triangle 1 where a picture may show some of it, from either side: where not all samples on and around
// it show something nearer.
//   viewProjection  world mm -> clip space
//   size            of the picture, in samples
//   output          those that reach behind the camera are taken to be seen, and hide nothing
//   cost            350,000 triangles, 2560x1920: 0.06 s of CPU; memory of some rows of the picture
std::vector<std::uint8_t> seenTriangles(const Mesh& mesh, const glm::mat4& viewProjection, glm::ivec2 size);

// trianglesWithin: per triangle 1 where it lies within `reach` mm of a marked one, through space; so do some that are up to
// half as far again away, or, if they are larger than that, their own size.
//   cost     350,000 triangles: 0.01 s
std::vector<std::uint8_t> trianglesWithin(const Mesh& mesh, const std::vector<std::uint8_t>& isMarked,
                                          float reach);

// selectTriangles: a mesh of some triangles in their order, with the vertices that they use in the order of first use.
Mesh selectTriangles(const Mesh& mesh, const std::vector<std::uint32_t>& triangles);

}  // namespace sonoskin
