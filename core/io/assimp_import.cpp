#include "core/io/assimp_import.h"

#include <assimp/scene.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/error.h"

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
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
      require(node.mMeshes[m] < scene_.mNumMeshes, "{} has a part without a mesh; get a fresh copy.",
              path_.string());
      addMesh(*scene_.mMeshes[node.mMeshes[m]], toWorld);
    }
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

}  // namespace

Mesh meshOf(const aiScene& scene, const fs::path& path) { return Collector(scene, path).collect(); }

}  // namespace sonoskin
