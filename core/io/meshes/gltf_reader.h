#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// readGltf: what a glTF 2.0 file shows: GLB, or text with its buffers in it or beside it. Nodes' transforms, skeletons and
// morph targets as they stand at rest; KHR_mesh_quantization, KHR_draco_mesh_compression and EXT_meshopt_compression.
//   output  mm, LPS: 1000 (x, -z, y), for glTF is in metres with +Y up and its front toward +Z; vertices at equal positions
//           are one; normals and texture coordinates where all parts have them
//   errors  Error: damaged, an extension that is required and not known here, no triangles; Cancelled. Points and lines
//           beside a surface are warned of
Mesh readGltf(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
