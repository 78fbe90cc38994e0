#include "core/io/mesh_reader.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <xxhash.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <string_view>
#include <unordered_map>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/ply_reader.h"
#include "core/io/reader_process.h"
#include "core/io/reader_wire.h"
#include "core/mesh/mesh_doubts.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// Vertices at equal positions, and where they went.
struct PositionHash {
  std::size_t operator()(const glm::vec3& p) const { return std::size_t(XXH3_64bits(&p, sizeof p)); }
};
using Places = std::unordered_map<glm::vec3, std::uint32_t, PositionHash>;

glm::vec3 vectorOf(const aiVector3D& v) { return {v.x, v.y, v.z}; }

// What does not spread over a picture is something else, such as the visibility in our own GLB files.
bool hasArea(const std::vector<std::array<glm::vec2, 3>>& uvs) {
  return std::any_of(uvs.begin(), uvs.end(), [](const std::array<glm::vec2, 3>& c) {
    const glm::vec2 a = c[1] - c[0], b = c[2] - c[0];
    return a.x * b.y != a.y * b.x;
  });
}

// Collects all parts of an assimp scene in one mesh.
class Collector {
 public:
  Collector(const aiScene& scene, const fs::path& path) : scene_(scene), path_(path) {}

  Mesh collect() {
    addNode(*scene_.mRootNode, aiMatrix4x4());
    for (glm::vec3& n : mesh_.normals) {
      const float length = glm::length(n);
      normalsGiven_ = normalsGiven_ && length > 0;
      n /= length > 0 ? length : 1;
    }
    if (!normalsGiven_) mesh_.normals.clear();
    if (!uvsGiven_ || !hasArea(mesh_.cornerUvs)) mesh_.cornerUvs.clear();
    return std::move(mesh_);
  }

 private:
  void addNode(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 toWorld = parent * node.mTransformation;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) addMesh(*scene_.mMeshes[node.mMeshes[m]], toWorld);
    for (unsigned c = 0; c < node.mNumChildren; ++c) addNode(*node.mChildren[c], toWorld);
  }

  void addMesh(const aiMesh& part, const aiMatrix4x4& toWorld) {
    const aiMatrix3x3 turn(toWorld);
    const bool mirrors = turn.Determinant() < 0;
    std::vector<std::uint32_t> moved(part.mNumVertices);
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const glm::vec3 normal = part.HasNormals() ? vectorOf(turn * part.mNormals[v]) : glm::vec3(0);
      moved[v] = place(vectorOf(toWorld * part.mVertices[v]), normal);
    }
    normalsGiven_ = normalsGiven_ && part.HasNormals();
    uvsGiven_ = uvsGiven_ && part.HasTextureCoords(0);
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      require(std::max({face.mIndices[0], face.mIndices[1], face.mIndices[2]}) < part.mNumVertices,
              "{} has a triangle without vertices; get a fresh copy.", path_.string());
      Triangle t{moved[face.mIndices[0]], moved[face.mIndices[1]], moved[face.mIndices[2]]};
      if (mirrors) std::swap(t[1], t[2]);
      mesh_.triangles.push_back(t);
      if (uvsGiven_) addUvs(part.mTextureCoords[0], face, mirrors);
    }
  }

  // Per corner, for vertices on both sides of a seam of the picture become one.
  void addUvs(const aiVector3D* uvs, const aiFace& face, bool mirrors) {
    std::array<glm::vec2, 3> corners;
    for (unsigned i = 0; i < 3; ++i) corners[i] = {uvs[face.mIndices[i]].x, uvs[face.mIndices[i]].y};
    if (mirrors) std::swap(corners[1], corners[2]);
    mesh_.cornerUvs.push_back(corners);
  }

  std::uint32_t place(glm::vec3 position, const glm::vec3& normal) {
    require(std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z),
            "{} has a vertex at no finite position; get a fresh copy.", path_.string());
    position += 0.0f;  // -0 and 0 are one place
    const auto [found, isNew] = places_.try_emplace(position, std::uint32_t(mesh_.positions.size()));
    if (isNew) {
      mesh_.positions.push_back(position);
      mesh_.normals.emplace_back(0);
    }
    mesh_.normals[found->second] += normal;
    return found->second;
  }

  const aiScene& scene_;
  const fs::path& path_;
  Mesh mesh_;
  Places places_;
  bool normalsGiven_ = true, uvsGiven_ = true;
};

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
  const int without = format == FileFormat::stl ? int(aiComponent_NORMALS) : 0;
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              without | aiComponent_COLORS | aiComponent_TANGENTS_AND_BITANGENTS |
                                  aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS | aiComponent_TEXTURES);
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
  return Collector(*scene, path).collect();
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

Mesh readMesh(const fs::path& path, const Progress& progress) {
  if (!readersRun()) return parseMesh(path, progress);
  return meshFrom(readApart(ReaderTask::mesh, path, progress).bytes(), path);
}

Mesh parseMesh(const fs::path& path, const Progress& progress) {
  const FileFormat format = requireFormat(FileKind::readMesh, path);
  progress.update(0);
  Mesh mesh = format == FileFormat::ply ? readPly(path, progress.part(0, 0.9)) : readWithAssimp(path, format);
  progress.update(0.9);
  require(!mesh.empty(), "{} holds no triangles; choose a file with a surface.", path.string());
  if (format == FileFormat::glb)
    turn(
        mesh, [](const glm::vec3& v) { return glm::vec3(v.x, -v.z, v.y); }, 1000);
  else if (format != FileFormat::threeMf && saysRas(path))
    turn(
        mesh, [](const glm::vec3& v) { return glm::vec3(-v.x, -v.y, v.z); }, 1);
  requireExtent(mesh, path.string());
  if (mesh.normals.empty()) computeNormals(mesh);
  progress.update(1);
  return mesh;
}

}  // namespace sonoskin
