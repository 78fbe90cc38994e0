#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// readStl: a surface in STL: text, in small or capital letters, or binary, whatever a binary file begins with; several
// solids are one. [3D Systems 1989]
//   output  world mm, LPS: SPACE=RAS in a binary file's first 80 bytes or behind a text's "solid" is obeyed; vertices at
//           equal positions are one; without normals, for those of the file are flat
//   errors  Error: cut off, damaged, no triangles; Cancelled. A text without its last line is warned of
Mesh readStl(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
