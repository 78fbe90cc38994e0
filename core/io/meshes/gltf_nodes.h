#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/io/meshes/gltf_file.h"

namespace sonoskin {

// GltfNodes: where the nodes of a glTF file stand. [glTF 2.0, section 3.5]
//   world   of each node, from its own frame to the scene's
//   shown   those that the scene that is to be shown holds, in the order of the tree: each once
struct GltfNodes {
  std::vector<glm::dmat4> world;
  std::vector<std::size_t> shown;
};

// placeGltfNodes: of all nodes. A file without scenes shows all of its nodes; of several the one that it names is shown, or
// the first, which is warned of.
//   errors  Error: damaged: a node below two others or below itself, or more than 256 nodes deep; no finite transform
GltfNodes placeGltfNodes(const GltfFile& file);

}  // namespace sonoskin
