#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// readMesh: reads a triangle surface: PLY, STL, OBJ, GLB, 3MF or VTP, known by the name's extension, or a legacy VTK file of
// polygons.
//   output  world mm, LPS: glTF is in metres with +Y up, 3MF in the unit that it says; in PLY, STL, OBJ and VTP
//           SPACE=RAS is obeyed where each of them has it, and without a mark LPS and mm are assumed, as 3D Slicer does.
//           Polygons become triangles, parts become one mesh, vertices at equal positions become one, except in PLY and
//           VTP, which keep their own. Normals are those of the file, or made; visibility and labels where a PLY or VTP has
//           them; texture coordinates where all of an OBJ, GLB, PLY or VTP has them. What is left out is warned of.
//   errors  Error: no such file, another extension, damaged or incomplete, no triangles; Cancelled
Mesh readMesh(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
