#include "core/io/meshes/gltf_draco.h"

#include <draco/compression/decode.h>

namespace sonoskin {

struct GltfDraco::Unpacked {
  std::unique_ptr<draco::Mesh> mesh;
};

GltfDraco::GltfDraco(const GltfFile& file, const nlohmann::json& packing)
    : file_(file), packing_(packing), unpacked_(std::make_unique<Unpacked>()) {
  const auto bytes = file.bytesOf(file.item("bufferViews", file.number(packing, "bufferView"))).bytes;
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto result = decoder.DecodeMeshFromBuffer(&buffer);
  file.check(result.ok());
  unpacked_->mesh = std::move(result).value();
  file.check(unpacked_->mesh != nullptr);
}

GltfDraco::~GltfDraco() = default;

bool GltfDraco::has(const std::string& attribute) const {
  return packing_.at("attributes").contains(attribute);
}

std::vector<float> GltfDraco::floats(const std::string& attribute, std::size_t components) const {
  const draco::Mesh& mesh = *unpacked_->mesh;
  const std::size_t id = file_.number(packing_.at("attributes"), attribute.c_str());
  const draco::PointAttribute* from = mesh.GetAttributeByUniqueId(std::uint32_t(id));
  file_.check(from && std::size_t(from->num_components()) == components && components <= 4);
  std::vector<float> values(mesh.num_points() * components);
  for (draco::PointIndex p(0); p < mesh.num_points(); ++p) {
    std::array<float, 4> value{};
    file_.check(from->ConvertValue<float>(from->mapped_index(p), std::int8_t(components), value.data()));
    std::copy_n(value.begin(), components, values.begin() + std::ptrdiff_t(p.value() * components));
  }
  return values;
}

std::vector<std::uint32_t> GltfDraco::indices() const {
  const draco::Mesh& mesh = *unpacked_->mesh;
  std::vector<std::uint32_t> indices;
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
    for (const draco::PointIndex& p : mesh.face(f)) indices.push_back(p.value());
  return indices;
}

}  // namespace sonoskin
