#include "core/io/mesh_writer.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/mesh_encoders.h"

namespace sonoskin {
namespace {

struct Format {
  const char* extension;
  Bytes (*encode)(const Mesh&);  // none: write3mf
};
constexpr std::array<Format, 5> kFormats{
    {{".ply", encodePly}, {".stl", encodeStl}, {".obj", encodeObj}, {".glb", encodeGlb}, {".3mf", nullptr}}};

const Format& formatOf(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  for (const Format& format : kFormats)
    if (format.extension == extension) return format;
  throw Error(fmt::format("{} cannot be written: the name of a surface file ends in {}.", path.string(),
                          fmt::join(meshExtensions(), ", ")),
              Error::Kind::usage);
}

// A mesh that contradicts itself would become a damaged file.
void checkWritable(const Mesh& mesh) {
  const std::size_t n = mesh.positions.size();
  require(!mesh.empty(), "There is no surface to write.");
  require((mesh.normals.empty() || mesh.normals.size() == n) &&
              (mesh.visibility.empty() || mesh.visibility.size() == n) &&
              (mesh.measured.empty() || mesh.measured.size() == n) &&
              (mesh.labels.empty() || mesh.labels.size() == n),
          "The surface has {} vertices but {} normals, {} visibilities, {} measured shares and {} labels.", n,
          mesh.normals.size(), mesh.visibility.size(), mesh.measured.size(), mesh.labels.size());
  for (const glm::vec3& p : mesh.positions)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
            "The surface has a vertex at no finite position.");
  for (const Triangle& t : mesh.triangles)
    require(std::max({t[0], t[1], t[2]}) < n, "A triangle of the surface uses a vertex that does not exist.");
}

}  // namespace

const std::vector<std::string>& meshExtensions() {
  static const std::vector<std::string> extensions = [] {
    std::vector<std::string> all;
    for (const Format& format : kFormats) all.emplace_back(format.extension);
    return all;
  }();
  return extensions;
}

void writeMesh(const std::filesystem::path& path, const Mesh& mesh, const Progress& progress) {
  const Format& format = formatOf(path);
  checkWritable(mesh);
  progress.update(0);
  if (format.encode) {
    const Bytes bytes = format.encode(mesh);
    progress.update(0.5);
    writeBytes(path, bytes.data(), bytes.size());
  } else {
    writeAtomically(path, [&](const std::filesystem::path& temporary) { write3mf(temporary, mesh); });
  }
  progress.update(1);
}

}  // namespace sonoskin
