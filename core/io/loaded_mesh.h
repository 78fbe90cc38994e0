#pragma once

#include <filesystem>

#include "core/mesh/mesh.h"

// A mesh as it comes out of a file, before anything else sees it.
namespace sonoskin {

// settleMesh: makes a mesh keep what mesh.h promises, as far as its file leaves it open.
//   input   mesh  indices with a vertex each
//   output  normals of length 1: where one cannot be, all are made anew; visibility and measured cut to 0 to 1, what is no
//           number is 0; texture coordinates dropped where one is not finite
void settleMesh(Mesh& mesh);

// checkMesh: refuses what cannot be a surface in mm, or breaks a promise of mesh.h.
//   errors  Error: no triangles, or some without a vertex; vertices at no finite place; an extent or a distance that no
//           surface of a body has; lists that do not fit the positions, or hold what settleMesh would not leave
void checkMesh(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace sonoskin
