#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/io/mesh_encoders.h"
#include "core/mesh/mesh.h"

struct aiScene;

// What our writers by way of assimp share. Its scenes own what they point to.
namespace sonoskin {

// meshFileHeader: program, unit and frame, for the first line of a file.
std::string meshFileHeader(const MeshPlacement& placement = {});

// assimpScene: one surface below the root, where assimp's writer of 3MF looks for it, with a plain skin-like material.
// Without uv the visibility travels as the first texture coordinate, the only array of numbers that assimp has.
std::unique_ptr<aiScene> assimpScene(const Mesh& mesh, const std::vector<glm::vec2>& uv = {});

// exportScene: the bytes of a file in one of assimp's formats.
//   errors  Error: assimp cannot write it in that format
Bytes exportScene(const aiScene& scene, const char* format);

// obj: with our header, and lines of one's own below it (each begins with a line break).
//   errors  as exportScene
Bytes obj(const aiScene& scene, const std::string& below = {}, const MeshPlacement& placement = {});

// glb: glTF 2.0 binary, with our name and after `edit` has changed its JSON.
//   errors  as exportScene
Bytes glb(const aiScene& scene, const std::function<void(nlohmann::json&)>& edit);

// asGltf: metres, +Y up, front toward +Z: 0.001 (x, z, -y), a rotation; with normals.
Mesh asGltf(const Mesh& mesh);

}  // namespace sonoskin
