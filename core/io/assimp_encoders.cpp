#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/assimp_scene.h"
#include "core/io/file_bytes.h"
#include "core/io/mesh_encoders.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// The visibility under a name of its own instead of a texture coordinate.
void nameVisibility(nlohmann::json& root) {
  auto& attributes = root["meshes"][0]["primitives"][0]["attributes"];
  const std::size_t index = attributes["TEXCOORD_0"];
  attributes.erase("TEXCOORD_0");
  attributes["_VISIBILITY"] = index;
  auto& accessor = root["accessors"][index];
  accessor["type"] = "SCALAR";
  for (const char* bound : {"min", "max"}) accessor[bound].erase(1);
  root["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteStride"] = 2 * sizeof(float);
}

// Whether a file of ZIP's kind is complete: it ends with a directory that lies where it says and names the model. assimp
// does not tell when the disk is full, and leaves out what found no room.  [APPNOTE 4.3.16]
bool isWhole3mf(const fs::path& path) {
  const std::uintmax_t size = fileSize(path);
  struct [[gnu::packed]] {
    char mark[4];
    std::uint16_t disks[4];
    std::uint32_t directoryBytes, directoryAt;
    std::uint16_t comment;
  } end{};
  std::ifstream file(path, std::ios::binary);
  file.seekg(-std::streamoff(sizeof end), std::ios::end).read(reinterpret_cast<char*>(&end), sizeof end);
  if (!file || std::memcmp(end.mark, "PK\5\6", 4) ||
      std::uintmax_t(end.directoryAt) + end.directoryBytes + sizeof end != size)
    return false;
  std::string directory(end.directoryBytes, ' ');
  file.seekg(std::streamoff(end.directoryAt)).read(directory.data(), std::streamsize(directory.size()));
  return file && directory.starts_with("PK\1\2") && directory.find("3DModel.model") != std::string::npos;
}

}  // namespace

Bytes encodeStl(const Mesh& mesh, const MeshPlacement& placement) {
  Mesh flat{mesh.positions, {}, {}, mesh.triangles, {}};  // without normals, assimp makes the triangles' own
  Bytes bytes = exportScene(*assimpScene(flat), "stlb");
  // Must not begin with "solid": readers would take the file for text.
  std::fill_n(bytes.begin(), 80, std::uint8_t(' '));
  const std::string text = meshFileHeader(placement);
  std::copy(text.begin(), text.end(), bytes.begin());
  return bytes;
}

Bytes encodeObj(const Mesh& mesh, const MeshPlacement& placement) {
  return obj(*assimpScene({mesh.positions, mesh.normals, {}, mesh.triangles, {}}), {}, placement);
}

Bytes encodeGlb(const Mesh& mesh) {
  require(36 * mesh.positions.size() + 12 * mesh.triangles.size() < 0xFFFF0000u,
          "The surface is too large for a GLB file; write PLY instead.");
  return glb(*assimpScene(asGltf(mesh)), [&](nlohmann::json& root) {
    if (!mesh.visibility.empty()) nameVisibility(root);
  });
}

void write3mf(const fs::path& path, const Mesh& mesh) {
  Assimp::Exporter exporter;
  const bool written = exporter.Export(assimpScene(mesh).get(), "3mf", path.string()) == aiReturn_SUCCESS;
  if (!written || !isWhole3mf(path))
    throw Error(
        fmt::format("{} could not be written as 3MF; the disk may be full, make room or choose another "
                    "place.",
                    path.filename().string()),
        Error::Kind::system);
}

}  // namespace sonoskin
