#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// readObj: a surface in Wavefront's OBJ: vertices (v, colours left out), normals (vn), texture coordinates (vt) and polygons
// (f, with negative indices too); groups are one; materials, lines and points are left out.
//   output  world mm, LPS: SPACE=RAS in a comment is obeyed; vertices in their order in the file, those at equal positions
//           are one and those without a face none; normals and texture coordinates where all faces have them
//   errors  Error: no numbers where some should be, an index without a vertex, free-form surfaces, no triangles; Cancelled
Mesh readObj(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
