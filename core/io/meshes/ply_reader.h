#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// readPly: reads text and binary PLY of either byte order; elements and properties that a Mesh does not have are
// skipped, polygons and strips of triangles are split.
//   output  world mm, LPS: SPACE=RAS in a comment is obeyed; vertices as in the file; normals, visibility, measured (cut to 0 to 1), labels (0 to 255) and texture
//           coordinates only where the file has them
//   errors  Error: damaged or incomplete; more elements than the file has room for (looked at before memory is
//           taken for them); positions that are not finite; Cancelled
Mesh readPly(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
