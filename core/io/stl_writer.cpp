#include <fmt/format.h>

#include "core/base/version.h"
#include "core/io/byte_sink.h"
#include "core/io/mesh_encoders.h"

namespace sonoskin {

Bytes encodeStl(const Mesh& mesh) {
  ByteSink out(84 + 50 * mesh.triangles.size());
  // Must not begin with "solid": readers would take the file for text.
  out.text(fmt::format("{:<80}", fmt::format("Sonoskin {}, units mm, SPACE=LPS", kVersion)));
  out.number(std::uint32_t(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const glm::vec3 n = glm::cross(b - a, c - a);
    const float length = glm::length(n);
    out.number(length > 0 ? n / length : glm::vec3(0));
    for (const glm::vec3& p : {a, b, c}) out.number(p);
    out.number(std::uint16_t(0));
  }
  return out.take();
}

}  // namespace sonoskin
