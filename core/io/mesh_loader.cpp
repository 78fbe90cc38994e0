#include "core/io/mesh_loader.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstring>
#include <string_view>

#include "core/base/error.h"
#include "core/io/assimp_import.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/loaded_mesh.h"
#include "core/io/ply_reader.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// assimp trusts the count of a binary STL's triangles.
void checkStl(const std::vector<std::uint8_t>& bytes, const fs::path& path) {
  if (bytes.size() >= 5 && !std::memcmp(bytes.data(), "solid", 5))
    return;  // text, or a binary file that says so
  std::uint32_t triangles = 0;
  if (bytes.size() >= 84) std::memcpy(&triangles, bytes.data() + 80, 4);
  require(bytes.size() >= 84 && bytes.size() - 84 >= std::uint64_t(50) * triangles,
          "{} ends before all of its triangles; the copy is incomplete, get a fresh one.", path.string());
}

Mesh readWithAssimp(const fs::path& path, FileFormat format) {
  // From memory, so that a file cannot lead to others.
  const std::vector<std::uint8_t> bytes = readBytes(path);
  if (format == FileFormat::stl) checkStl(bytes, path);
  Assimp::Importer importer;
  // The normals of STL are flat; colours would keep apart what lies at one place.
  const unsigned without = format == FileFormat::stl ? unsigned(aiComponent_NORMALS) : 0;
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              int(without | aiComponent_COLORS | aiComponent_TANGENTS_AND_BITANGENTS |
                                  aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS | aiComponent_TEXTURES));
  const std::string hint = lowerExtension(path).substr(1);
  const aiScene* scene = nullptr;
  try {
    scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(),
                                        aiProcess_Triangulate | aiProcess_RemoveComponent, hint.c_str());
    if (!scene && importer.GetException()) std::rethrow_exception(importer.GetException());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {  // its own words may quote the file
  }
  require(
      scene && scene->mRootNode,
      "{} is damaged, incomplete or of a kind that is not known here; get a fresh copy, or save it as PLY.",
      path.string());
  return meshOf(*scene, path);
}

bool saysRas(const fs::path& path) {
  const std::vector<std::uint8_t> bytes = readBytes(path, 4096);
  return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).find("SPACE=RAS") !=
         std::string_view::npos;
}

// A rotation of all axes of a mesh, so the winding stays.
template <class Turn>
void turn(Mesh& mesh, const Turn& turned, float scale) {
  for (glm::vec3& p : mesh.positions) p = scale * turned(p);
  for (glm::vec3& n : mesh.normals) n = turned(n);
}

}  // namespace

Mesh parseMesh(const fs::path& path, const Progress& progress) {
  const FileFormat format = requireFormat(FileKind::readMesh, path);
  progress.update(0);
  Mesh mesh = format == FileFormat::ply ? readPly(path, progress.part(0, 0.9)) : readWithAssimp(path, format);
  progress.update(0.9);
  if (format == FileFormat::glb)
    turn(
        mesh, [](const glm::vec3& v) { return glm::vec3(v.x, -v.z, v.y); }, 1000);
  else if (format != FileFormat::threeMf && saysRas(path))
    turn(
        mesh, [](const glm::vec3& v) { return glm::vec3(-v.x, -v.y, v.z); }, 1);
  settleMesh(mesh);
  checkMesh(mesh, path);
  progress.update(1);
  return mesh;
}

}  // namespace sonoskin
