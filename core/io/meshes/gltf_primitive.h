#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/io/meshes/gltf_numbers.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// GltfPrimitive: one part of a mesh of a glTF file, in the mesh's frame, with the morph targets' default weights in it.
//   normals, uvs        as many as positions, or empty; uvs with v up
//   joints, weights     of the bones that move a vertex, four at a time; empty without a skeleton
//   triangles           indices into positions
struct GltfPrimitive {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> uvs;
  std::vector<glm::vec4> joints, weights;
  std::size_t influences = 0;  // sets of four for each vertex, one set after another
  std::vector<Triangle> triangles;
};

// readGltfPrimitive: of triangles, strips and fans; packed by KHR_draco_mesh_compression too. morph: the weights of its
// targets, as far as there are some.
//   output  without triangles where it is one of points or lines
//   errors  Error: damaged
GltfPrimitive readGltfPrimitive(const GltfFile& file, const nlohmann::json& primitive,
                                const std::vector<float>& morph, GltfNumbers& numbers);

}  // namespace sonoskin
