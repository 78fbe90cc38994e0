#include "core/io/mesh_writer.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_formats.h"
#include "core/io/mesh_encoders.h"

namespace sonoskin {
namespace {

// The bytes of all formats but 3MF, which goes to a file.
Bytes encoded(FileFormat format, const Mesh& mesh, const MeshFileOptions& options) {
  switch (format) {
    case FileFormat::stl:
      return encodeStl(mesh, options.placement);
    case FileFormat::obj:
      return encodeObj(mesh, options.placement);
    case FileFormat::glb:
      return encodeGlb(mesh);
    case FileFormat::vtp:
      return encodeVtp(mesh, options.placement);
    case FileFormat::dicomStl:
      return encodeDicomStl(mesh, options.patient);
    default:
      return encodePly(mesh, options.placement);
  }
}

// A mesh that contradicts itself would become a damaged file.
void checkWritable(const Mesh& mesh) {
  const std::size_t n = mesh.positions.size();
  require(!mesh.empty(), "There is no surface to write; make one first.");
  require((mesh.normals.empty() || mesh.normals.size() == n) &&
              (mesh.visibility.empty() || mesh.visibility.size() == n) &&
              (mesh.measured.empty() || mesh.measured.size() == n) &&
              (mesh.labels.empty() || mesh.labels.size() == n),
          "The surface has {} vertices but {} normals, {} visibilities, {} measured shares and {} labels; "
          "each is for "
          "all or for none.",
          n, mesh.normals.size(), mesh.visibility.size(), mesh.measured.size(), mesh.labels.size());
  for (const glm::vec3& p : mesh.positions)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
            "The surface has a vertex at no finite position; make it anew.");
  for (const Triangle& t : mesh.triangles)
    require(std::max({t[0], t[1], t[2]}) < n,
            "A triangle of the surface uses a vertex that does not exist; make it anew.");
}

}  // namespace

void writeMesh(const std::filesystem::path& path, const Mesh& mesh, const Progress& progress) {
  writeMesh(path, mesh, MeshFileOptions(), progress);
}

void writeMesh(const std::filesystem::path& path, const Mesh& mesh, const MeshFileOptions& options,
               const Progress& progress) {
  const FileFormat format = requireFormat(FileKind::writtenMesh, path);
  checkWritable(mesh);
  progress.update(0);
  if (format == FileFormat::threeMf) {
    writeAtomically(path, [&](const std::filesystem::path& temporary) { write3mf(temporary, mesh); });
  } else {
    const bool moves = leavesPlacementOpen(format) && options.placement != MeshPlacement();
    const Bytes bytes = encoded(format, moves ? placedMesh(mesh, options.placement) : mesh, options);
    progress.update(0.5);
    writeBytes(path, bytes.data(), bytes.size());
  }
  progress.update(1);
}

}  // namespace sonoskin
