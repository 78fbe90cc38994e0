#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// encodePly: the bytes of a binary little-endian PLY file of a mesh.
//   vertices  float x y z; float nx ny nz and float visibility where the mesh has them
//   faces     uchar 3, then three ints
std::vector<std::uint8_t> encodePly(const Mesh& mesh);

}  // namespace sonoskin
