#include "core/io/ply_writer.h"

#include <bit>
#include <cstring>
#include <string>

#include "core/base/error.h"
#include "core/base/version.h"

namespace sonoskin {
namespace {

static_assert(std::endian::native == std::endian::little, "the numbers are written as they lie in memory");

constexpr std::size_t kFaceBytes = 1 + 3 * sizeof(std::int32_t);

std::string header(const Mesh& mesh) {
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "comment Sonoskin {}, units mm, SPACE=LPS\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n",
      kVersion, mesh.positions.size());
  if (!mesh.normals.empty()) text += "property float nx\nproperty float ny\nproperty float nz\n";
  if (!mesh.visibility.empty()) text += "property float visibility\n";
  text += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                      mesh.triangles.size());
  return text;
}

template <class T>
std::uint8_t* put(std::uint8_t* out, const T& value) {
  std::memcpy(out, &value, sizeof value);
  return out + sizeof value;
}

}  // namespace

std::vector<std::uint8_t> encodePly(const Mesh& mesh) {
  const bool normals = !mesh.normals.empty(), visibility = !mesh.visibility.empty();
  const std::string head = header(mesh);
  const std::size_t vertexBytes = sizeof(float) * (3 + (normals ? 3 : 0) + (visibility ? 1 : 0));
  std::vector<std::uint8_t> bytes(head.size() + vertexBytes * mesh.positions.size() +
                                  kFaceBytes * mesh.triangles.size());
  std::memcpy(bytes.data(), head.data(), head.size());
  std::uint8_t* out = bytes.data() + head.size();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    out = put(out, mesh.positions[v]);
    if (normals) out = put(out, mesh.normals[v]);
    if (visibility) out = put(out, mesh.visibility[v]);
  }
  for (const Triangle& t : mesh.triangles) {
    *out++ = 3;
    out = put(out, t);
  }
  return bytes;
}

}  // namespace sonoskin
