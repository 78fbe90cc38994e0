#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// readVtp: a surface in VTK's XML format for polygons: all pieces, polygons and strips of triangles; as text, in letters or
// behind the header, plain or packed by zlib, of either byte order.
//   output  world mm, LPS: a text SPACE with the value RAS in the field data is obeyed; vertices as in the file; normals,
//           texture coordinates, visibility, measured and labels where the file has them, as in PLY
//   errors  Error: damaged or incomplete, packed by another than zlib, no triangles; Cancelled. Points and lines beside a
//           surface are warned of
Mesh readVtp(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
