#include <fmt/format.h>

#include <iterator>

#include "core/base/version.h"
#include "core/io/mesh_encoders.h"

namespace sonoskin {

Bytes encodeObj(const Mesh& mesh) {
  Bytes text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "# Sonoskin {}, units mm, SPACE=LPS\n", kVersion);
  for (const glm::vec3& p : mesh.positions) fmt::format_to(out, "v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
  for (const glm::vec3& n : mesh.normals) fmt::format_to(out, "vn {:.6g} {:.6g} {:.6g}\n", n.x, n.y, n.z);
  const bool normals = !mesh.normals.empty();
  for (const Triangle& t : mesh.triangles) {
    const std::uint32_t a = t[0] + 1, b = t[1] + 1, c = t[2] + 1;  // counted from 1
    if (normals)
      fmt::format_to(out, "f {0}//{0} {1}//{1} {2}//{2}\n", a, b, c);
    else
      fmt::format_to(out, "f {} {} {}\n", a, b, c);
  }
  return text;
}

}  // namespace sonoskin
