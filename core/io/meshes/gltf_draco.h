#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/io/meshes/gltf_file.h"

namespace sonoskin {

// GltfDraco: a primitive that KHR_draco_mesh_compression has packed: its indices and attributes, with the names that these
// have in glTF.
class GltfDraco {
 public:
  // packing: the extension's object.  errors  Error: damaged
  GltfDraco(const GltfFile& file, const nlohmann::json& packing);
  ~GltfDraco();

  bool has(const std::string& attribute) const;
  // floats: `components` for each vertex.  errors  Error: damaged
  std::vector<float> floats(const std::string& attribute, std::size_t components) const;
  std::vector<std::uint32_t> indices() const;

 private:
  struct Unpacked;
  const GltfFile& file_;
  const nlohmann::json& packing_;
  std::unique_ptr<Unpacked> unpacked_;
};

}  // namespace sonoskin
