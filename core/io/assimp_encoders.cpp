#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <cstring>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/error.h"
#include "core/base/version.h"
#include "core/io/byte_sink.h"
#include "core/io/mesh_encoders.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

std::string header() { return std::string("Sonoskin ") + kVersion + ", units mm, SPACE=LPS"; }

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

// The visibility travels as the first texture coordinate, the only array of numbers that assimp has.
std::unique_ptr<aiMesh> partOf(const Mesh& mesh) {
  auto part = std::make_unique<aiMesh>();
  part->mNumVertices = unsigned(mesh.positions.size());
  part->mVertices = new aiVector3D[mesh.positions.size()];
  std::transform(mesh.positions.begin(), mesh.positions.end(), part->mVertices, vectorOf);
  if (!mesh.normals.empty()) {
    part->mNormals = new aiVector3D[mesh.normals.size()];
    std::transform(mesh.normals.begin(), mesh.normals.end(), part->mNormals, vectorOf);
  }
  if (!mesh.visibility.empty()) {
    part->mNumUVComponents[0] = 2;
    part->mTextureCoords[0] = new aiVector3D[mesh.visibility.size()];
    std::transform(mesh.visibility.begin(), mesh.visibility.end(), part->mTextureCoords[0],
                   [](float v) { return aiVector3D(v, 1, 0); });
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

// One surface below the root, where assimp's writer of 3MF looks for it. The scene owns what it points to.
std::unique_ptr<aiScene> sceneOf(const Mesh& mesh) {
  auto scene = std::make_unique<aiScene>();
  scene->mNumMeshes = scene->mNumMaterials = 1;
  scene->mMeshes = new aiMesh*[1]();
  scene->mMeshes[0] = partOf(mesh).release();
  scene->mMaterials = new aiMaterial*[1]();
  scene->mMaterials[0] = skin().release();
  scene->mRootNode = new aiNode("root");
  auto* child = new aiNode("surface");
  child->mNumMeshes = 1;
  child->mMeshes = new unsigned[1]{0};
  scene->mRootNode->addChildren(1, &child);
  return scene;
}

Bytes exported(const Mesh& mesh, const char* format) {
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(sceneOf(mesh).get(), format);
  require(blob != nullptr, "The surface cannot be written in this format; write PLY instead.");
  const auto* first = static_cast<const std::uint8_t*>(blob->data);
  return {first, first + blob->size};
}

// The GLB's JSON, with the program's name and the visibility under its own.
std::string ownDocument(std::string_view text, bool visibility) {
  nlohmann::json root = nlohmann::json::parse(text);
  root["asset"]["generator"] = std::string("Sonoskin ") + kVersion;
  root.erase("extensionsUsed");  // names some that are not
  if (visibility) {
    auto& attributes = root["meshes"][0]["primitives"][0]["attributes"];
    const std::size_t index = attributes["TEXCOORD_0"];
    attributes.erase("TEXCOORD_0");
    attributes["_VISIBILITY"] = index;
    auto& accessor = root["accessors"][index];
    accessor["type"] = "SCALAR";
    for (const char* bound : {"min", "max"}) accessor[bound].erase(1);
    root["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteStride"] = 2 * sizeof(float);
  }
  std::string own = root.dump();
  own.resize((own.size() + 3) / 4 * 4, ' ');
  return own;
}

// Every file of ZIP's kind ends with a directory; assimp does not tell when the disk is full.
bool endsAsZip(const fs::path& path) {
  char end[22] = {};
  std::ifstream(path, std::ios::binary)
      .seekg(-std::streamoff(sizeof end), std::ios::end)
      .read(end, sizeof end);
  return !std::memcmp(end, "PK\5\6", 4);
}

}  // namespace

Bytes encodeStl(const Mesh& mesh) {
  Mesh flat{mesh.positions, {}, {}, mesh.triangles, {}};  // without normals, assimp makes the triangles' own
  Bytes bytes = exported(flat, "stlb");
  // Must not begin with "solid": readers would take the file for text.
  std::fill_n(bytes.begin(), 80, std::uint8_t(' '));
  const std::string text = header();
  std::copy(text.begin(), text.end(), bytes.begin());
  return bytes;
}

Bytes encodeObj(const Mesh& mesh) {
  Bytes bytes = exported({mesh.positions, mesh.normals, {}, mesh.triangles, {}}, "objnomtl");
  // In place of the first line, assimp's name.
  const std::string line = "# " + header();
  const auto end = std::find(bytes.begin(), bytes.end(), std::uint8_t('\n'));
  bytes.insert(bytes.erase(bytes.begin(), end), line.begin(), line.end());
  return bytes;
}

Bytes encodeGlb(const Mesh& mesh) {
  constexpr std::size_t kHead = 20;  // magic, version, length; length and kind of the JSON
  Mesh turned = mesh;
  if (turned.normals.empty()) computeNormals(turned);
  for (glm::vec3& p : turned.positions) p = 0.001f * glm::vec3(p.x, p.z, -p.y);
  for (glm::vec3& n : turned.normals) n = {n.x, n.z, -n.y};
  require(36 * mesh.positions.size() + 12 * mesh.triangles.size() < 0xFFFF0000u,
          "The surface is too large for a GLB file; write PLY instead.");
  const Bytes bytes = exported(turned, "glb2");
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  const std::string_view json(reinterpret_cast<const char*>(bytes.data()) + kHead, length);
  const std::string own = ownDocument(json, !mesh.visibility.empty());
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

void write3mf(const fs::path& path, const Mesh& mesh) {
  Assimp::Exporter exporter;
  const bool written = exporter.Export(sceneOf(mesh).get(), "3mf", path.string()) == aiReturn_SUCCESS;
  if (!written || !endsAsZip(path))
    throw Error("The surface could not be written as 3MF; is the disk full?", Error::Kind::system);
}

}  // namespace sonoskin
