#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// meshExtensions: the formats that writeMesh knows: ".ply", ".stl", ".obj", ".glb", ".3mf".
const std::vector<std::string>& meshExtensions();

// writeMesh: writes a mesh in the format of the name's extension, atomically.
//   input    mesh   world mm, LPS; indices within range
//   output   PLY    binary, with normals and, where there is one, `visibility` per vertex    mm, LPS in a
//   comment
//            STL    binary                                                                   mm, LPS in the
//            header OBJ    with normals                                                             mm, LPS
//            in a comment GLB    with normals; +Y up, front toward +Z: 0.001 (x, z, -y) of LPS metres 3MF mm,
//            axes as they are
//   errors   Error (usage): another extension; (system) the file cannot be written; Cancelled
// PLY is written by our own code because assimp, the library behind the other formats, drops vertex
// properties that it does not know.
void writeMesh(const std::filesystem::path& path, const Mesh& mesh, const Progress& progress = {});

}  // namespace sonoskin
