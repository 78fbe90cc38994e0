#include <fmt/format.h>

#include <string>

#include "core/base/version.h"
#include "core/io/byte_sink.h"
#include "core/io/mesh_encoders.h"

namespace sonoskin {
namespace {

std::string header(const Mesh& mesh, const MeshPlacement& placement) {
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "comment Sonoskin {}, {}\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n",
      kVersion, placementText(placement), mesh.positions.size());
  if (!mesh.normals.empty()) text += "property float nx\nproperty float ny\nproperty float nz\n";
  if (!mesh.visibility.empty()) text += "property float visibility\n";
  if (!mesh.measured.empty()) text += "property float measured\n";
  if (!mesh.labels.empty()) text += "property uchar label\n";
  text += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                      mesh.triangles.size());
  return text;
}

}  // namespace

Bytes encodePly(const Mesh& mesh, const MeshPlacement& placement) {
  const bool normals = !mesh.normals.empty(), visibility = !mesh.visibility.empty(),
             measured = !mesh.measured.empty(), labels = !mesh.labels.empty();
  const std::string head = header(mesh, placement);
  const std::size_t vertexBytes =
      sizeof(float) * (3 + (normals ? 3 : 0) + (visibility ? 1 : 0) + (measured ? 1 : 0)) + labels;
  ByteSink out(head.size() + vertexBytes * mesh.positions.size() + 13 * mesh.triangles.size());
  out.text(head);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    out.number(mesh.positions[v]);
    if (normals) out.number(mesh.normals[v]);
    if (visibility) out.number(mesh.visibility[v]);
    if (measured) out.number(mesh.measured[v]);
    if (labels) out.number(mesh.labels[v]);
  }
  for (const Triangle& t : mesh.triangles) {
    out.number(std::uint8_t(3));
    out.number(t);
  }
  return out.take();
}

}  // namespace sonoskin
