#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// readMesh: reads a triangle surface: PLY, STL, OBJ, GLB or 3MF, known by the name's extension.
//   output  world mm, LPS: GLB is taken as metres with +Y up; in PLY, STL and OBJ "SPACE=RAS" at the beginning of
//           the file is obeyed, and without a mark LPS and mm are assumed, as 3D Slicer does. Polygons become
//           triangles, parts become one mesh, vertices at equal positions become one, except in PLY, which keeps its
//           own. Normals are those of the file, or made; visibility and labels where a PLY has them; texture coordinates
//           where all of an OBJ, GLB or PLY has them.
//   errors  Error: no such file, another extension, damaged or incomplete, no triangles; Cancelled
Mesh readMesh(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
