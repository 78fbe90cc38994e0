#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// decimateMesh: fewer triangles, where the shape needs them least.
//   triangles  how many are wanted; a mesh with no more stays as it is
//   output     about so many; vertices are some of those of the mesh, with their normals, visibility and measured; borders stay
//              as they are. A manifold mesh stays manifold, which may leave some triangles more.
//   method     quadric errors (meshoptimizer). Collapsing edges can close a narrow place onto itself: then it is done
//              again with the triangles there kept as they are.
//   cost       180,000 triangles to 18,000: 0.3 s on one core
//   errors     Cancelled: at once; the library's call cannot be stopped and ends by itself in the background, before the next
//              one begins
Mesh decimateMesh(const Mesh& mesh, std::size_t triangles, const Progress& progress = {});

}  // namespace sonoskin
