#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// isVtkSurface: whether a file is a legacy VTK file of polygons, by its first lines; volumes have the same ending.
bool isVtkSurface(const std::filesystem::path& path);

// readVtkSurface: polygons and strips of triangles of a legacy VTK file, text or binary, versions 1 to 5.
//   output  world mm, LPS: SPACE=RAS in the second line is obeyed; vertices as in the file; normals and other attributes
//           are left out
//   errors  Error: damaged or incomplete, no triangles; Cancelled. Points and lines beside a surface are warned of
Mesh readVtkSurface(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
