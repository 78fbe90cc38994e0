#include "core/io/mesh_loader.h"

#include "core/io/file_formats.h"
#include "core/io/loaded_mesh.h"
#include "core/io/meshes/gltf_reader.h"
#include "core/io/meshes/obj_reader.h"
#include "core/io/meshes/ply_reader.h"
#include "core/io/meshes/stl_reader.h"
#include "core/io/meshes/three_mf_reader.h"
#include "core/io/meshes/vtk_surface_reader.h"
#include "core/io/meshes/vtp_reader.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// How a file is read.
Mesh (*readerOf(const fs::path& path))(const fs::path&, const Progress&) {
  if (isVtkSurface(path)) return readVtkSurface;
  switch (requireFormat(FileKind::readMesh, path)) {
    case FileFormat::stl:
      return readStl;
    case FileFormat::obj:
      return readObj;
    case FileFormat::glb:
      return readGltf;
    case FileFormat::threeMf:
      return readThreeMf;
    case FileFormat::vtp:
      return readVtp;
    default:
      return readPly;
  }
}

}  // namespace

Mesh parseMesh(const fs::path& path, const Progress& progress) {
  const auto read = readerOf(path);
  progress.update(0);
  Mesh mesh = read(path, progress.part(0, 0.9));
  progress.update(0.9);
  settleMesh(mesh);
  checkMesh(mesh, path);
  progress.update(1);
  return mesh;
}

}  // namespace sonoskin
