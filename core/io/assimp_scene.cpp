#include "core/io/assimp_scene.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/base/version.h"
#include "core/io/byte_sink.h"

namespace sonoskin {
namespace {

aiVector3D vectorOf(const glm::vec3& v) { return {v.x, v.y, v.z}; }

void setFaces(aiMesh& part, const std::vector<Triangle>& triangles) {
  const auto proper = [](const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; };
  part.mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  part.mNumFaces = unsigned(std::count_if(triangles.begin(), triangles.end(), proper));
  part.mFaces = new aiFace[part.mNumFaces];
  aiFace* face = part.mFaces;
  for (const Triangle& t : triangles) {
    if (!proper(t)) continue;
    face->mNumIndices = 3;
    face->mIndices = new unsigned[3]{t[0], t[1], t[2]};
    ++face;
  }
}

template <class Values, class ToVector>
void setCoordinates(aiMesh& part, const Values& values, const ToVector& toVector) {
  if (values.empty()) return;
  part.mNumUVComponents[0] = 2;
  part.mTextureCoords[0] = new aiVector3D[values.size()];
  std::transform(values.begin(), values.end(), part.mTextureCoords[0], toVector);
}

std::unique_ptr<aiMesh> partOf(const Mesh& mesh, const std::vector<glm::vec2>& uv) {
  auto part = std::make_unique<aiMesh>();
  part->mNumVertices = unsigned(mesh.positions.size());
  part->mVertices = new aiVector3D[mesh.positions.size()];
  std::transform(mesh.positions.begin(), mesh.positions.end(), part->mVertices, vectorOf);
  if (!mesh.normals.empty()) {
    part->mNormals = new aiVector3D[mesh.normals.size()];
    std::transform(mesh.normals.begin(), mesh.normals.end(), part->mNormals, vectorOf);
  }
  if (uv.empty()) {
    setCoordinates(*part, mesh.visibility, [](float v) { return aiVector3D(v, 1, 0); });
  } else {
    setCoordinates(*part, uv, [](const glm::vec2& v) { return aiVector3D(v.x, v.y, 0); });
  }
  setFaces(*part, mesh.triangles);
  return part;
}

std::unique_ptr<aiMaterial> skin() {
  auto material = std::make_unique<aiMaterial>();
  const aiString name("skin");
  const aiColor4D colour(0.78f, 0.53f, 0.42f, 1);
  const float metallic = 0, roughness = 0.55f;
  const int twoSided = 1;
  material->AddProperty(&name, AI_MATKEY_NAME);
  material->AddProperty(&colour, 1, AI_MATKEY_BASE_COLOR);
  material->AddProperty(&colour, 1, AI_MATKEY_COLOR_DIFFUSE);
  material->AddProperty(&metallic, 1, AI_MATKEY_METALLIC_FACTOR);
  material->AddProperty(&roughness, 1, AI_MATKEY_ROUGHNESS_FACTOR);
  material->AddProperty(&twoSided, 1, AI_MATKEY_TWOSIDED);
  return material;
}

}  // namespace

std::string meshFileHeader(const MeshPlacement& placement) {
  return std::string("Sonoskin ") + kVersion + ", " + placementText(placement);
}

std::unique_ptr<aiScene> assimpScene(const Mesh& mesh, const std::vector<glm::vec2>& uv) {
  auto scene = std::make_unique<aiScene>();
  scene->mNumMeshes = scene->mNumMaterials = 1;
  scene->mMeshes = new aiMesh*[1]();
  scene->mMeshes[0] = partOf(mesh, uv).release();
  scene->mMaterials = new aiMaterial*[1]();
  scene->mMaterials[0] = skin().release();
  scene->mRootNode = new aiNode("root");
  auto* child = new aiNode("surface");
  child->mNumMeshes = 1;
  child->mMeshes = new unsigned[1]{0};
  scene->mRootNode->addChildren(1, &child);
  return scene;
}

Bytes exportScene(const aiScene& scene, const char* format) {
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, format);
  require(blob != nullptr, "The surface cannot be written in this format; write PLY instead.");
  const auto* first = static_cast<const std::uint8_t*>(blob->data);
  return {first, first + blob->size};
}

Bytes obj(const aiScene& scene, const std::string& below, const MeshPlacement& placement) {
  Bytes bytes = exportScene(scene, "objnomtl");
  const std::string line = "# " + meshFileHeader(placement) + below;
  const auto end = std::find(bytes.begin(), bytes.end(), std::uint8_t('\n'));
  bytes.insert(bytes.erase(bytes.begin(), end), line.begin(), line.end());
  return bytes;
}

Bytes glb(const aiScene& scene, const std::function<void(nlohmann::json&)>& edit) {
  constexpr std::size_t kHead = 20;  // magic, version, length; length and kind of the JSON
  const Bytes bytes = exportScene(scene, "glb2");
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  nlohmann::json root =
      nlohmann::json::parse(std::string_view(reinterpret_cast<const char*>(bytes.data()) + kHead, length));
  root["asset"]["generator"] = std::string("Sonoskin ") + kVersion;
  root.erase("extensionsUsed");  // names some that are not
  edit(root);
  std::string own = root.dump();
  own.resize((own.size() + 3) / 4 * 4, ' ');
  ByteSink out(bytes.size() + own.size());
  out.text("glTF");
  out.number(std::uint32_t(2));
  out.number(std::uint32_t(bytes.size() - length + own.size()));
  out.number(std::uint32_t(own.size()));
  out.text("JSON");
  out.text(own);
  out.array(Bytes(bytes.begin() + kHead + length, bytes.end()));
  return out.take();
}

Mesh asGltf(const Mesh& mesh) {
  Mesh turned = mesh;
  if (turned.normals.empty()) computeNormals(turned);
  for (glm::vec3& p : turned.positions) p = 0.001f * glm::vec3(p.x, p.z, -p.y);
  for (glm::vec3& n : turned.normals) n = {n.x, n.z, -n.y};
  return turned;
}

}  // namespace sonoskin
