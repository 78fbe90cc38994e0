#pragma once

#include <filesystem>

#include "core/mesh/mesh.h"

struct aiScene;

namespace sonoskin {

// meshOf: all triangles of a scene that assimp has read from a file, as one mesh; points and lines are left out. Nothing
// in the scene is trusted, for assimp takes indices as they stand in the file.
//   input   scene  with a root node
//           path   of the file, for messages
//   output  in the scene's frame and unit; vertices at equal positions become one; normals where all parts have them;
//           texture coordinates where all parts have them and they span an area
//   errors  Error: a triangle without vertices, a node without a mesh, a vertex at no finite position
Mesh meshOf(const aiScene& scene, const std::filesystem::path& path);

}  // namespace sonoskin
