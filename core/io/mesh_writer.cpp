#include "core/io/mesh_writer.h"

#include <fmt/ranges.h>
#include <algorithm>

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/ply_writer.h"

namespace sonoskin {
namespace {

// A mesh that contradicts itself would become a damaged file.
void checkMesh(const Mesh& mesh) {
  const std::size_t n = mesh.positions.size();
  require(!mesh.empty(), "There is no surface to write.");
  require((mesh.normals.empty() || mesh.normals.size() == n) &&
              (mesh.visibility.empty() || mesh.visibility.size() == n),
          "The surface has {} vertices but {} normals and {} visibilities.", n, mesh.normals.size(),
          mesh.visibility.size());
  for (const Triangle& t : mesh.triangles)
    require(std::max({t[0], t[1], t[2]}) < n, "A triangle of the surface uses a vertex that does not exist.");
}

}  // namespace

const std::vector<std::string>& meshExtensions() {
  static const std::vector<std::string> extensions{".ply"};
  return extensions;
}

void writeMesh(const std::filesystem::path& path, const Mesh& mesh, const Progress& progress) {
  const std::string extension = lowerExtension(path);
  const auto& known = meshExtensions();
  if (std::find(known.begin(), known.end(), extension) == known.end())
    throw Error(fmt::format("{} cannot be written: the name of a surface file ends in {}.", path.string(),
                            fmt::join(known, ", ")),
                Error::Kind::usage);
  checkMesh(mesh);
  progress.update(0);
  const std::vector<std::uint8_t> bytes = encodePly(mesh);
  progress.update(0.5);
  writeBytes(path, bytes.data(), bytes.size());
  progress.update(1);
}

}  // namespace sonoskin
