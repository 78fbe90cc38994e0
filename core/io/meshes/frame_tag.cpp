#include "core/io/meshes/frame_tag.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "core/base/log.h"
#include "core/io/header_text.h"

namespace sonoskin {

MeshFrame frameNamed(std::string_view value) {
  const std::string name = lowerCase(value);
  if (name == "ras") return MeshFrame::ras;
  if (name != "lps")
    log(LogLevel::warning,
        "The mesh says that it is in a frame that is neither LPS nor RAS; LPS is assumed, so it may be "
        "turned or "
        "mirrored.");
  return MeshFrame::lps;
}

MeshFrame frameIn(std::string_view header) {
  constexpr std::string_view kMark = "SPACE";
  for (std::size_t at = header.find(kMark); at != std::string_view::npos; at = header.find(kMark, at + 1)) {
    std::string_view value = header.substr(at + kMark.size());
    const auto skipBlanks = [&] {
      value.remove_prefix(std::min(value.find_first_not_of(" \t"), value.size()));
    };
    skipBlanks();
    if (!value.starts_with('=')) continue;
    value.remove_prefix(1);
    skipBlanks();
    std::size_t end = 0;
    while (end < value.size() && std::isalpha(static_cast<unsigned char>(value[end]))) ++end;
    return frameNamed(value.substr(0, end));
  }
  return MeshFrame::lps;
}

void turnToLps(Mesh& mesh, MeshFrame from) {
  if (from == MeshFrame::lps) return;
  for (glm::vec3& p : mesh.positions) p = {-p.x, -p.y, p.z};
  for (glm::vec3& n : mesh.normals) n = {-n.x, -n.y, n.z};
}

}  // namespace sonoskin
