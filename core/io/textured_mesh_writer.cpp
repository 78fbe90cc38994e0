#include "core/io/textured_mesh_writer.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/assimp_scene.h"
#include "core/io/atomic_file.h"
#include "core/io/file_formats.h"
#include "core/io/png_encoder.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

bool isPicture(const Image& image) {
  return image.width > 0 && image.rgba.size() == 4 * std::size_t(image.width) * std::size_t(image.height);
}

void check(const TexturedMesh& surface) {
  const Mesh& mesh = surface.mesh;
  require(!mesh.empty(), "There is no surface to write; make one first.");
  require(
      surface.uv.size() == mesh.positions.size() && mesh.normals.size() == mesh.positions.size(),
      "A surface with pictures needs a normal and a place in the pictures for every vertex; bake it anew.");
  const bool fits = std::ranges::all_of(mesh.triangles, [&](const Triangle& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) { return v < mesh.positions.size(); });
  });
  require(fits, "A triangle of the surface uses a vertex that does not exist; make it anew.");
  require(isPicture(surface.colour), "A surface with pictures needs a colour; bake it anew.");
  require(surface.lit || (isPicture(surface.normals) && isPicture(surface.finish)),
          "A surface with pictures needs normals and a finish; bake it anew.");
}

aiTexture* embedded(const Image& image) {
  const std::vector<std::uint8_t> png = encodePng(image);
  auto* texture = new aiTexture;
  texture->mWidth = unsigned(png.size());  // bytes; height 0: a file
  texture->pcData = new aiTexel[(png.size() + sizeof(aiTexel) - 1) / sizeof(aiTexel)];
  std::memcpy(texture->pcData, png.data(), png.size());
  std::memcpy(texture->achFormatHint, "png", 4);
  return texture;
}

// Pictures that the scene holds are called by their numbers.
void addPictures(aiScene& scene, const TexturedMesh& surface, const Progress& progress) {
  std::vector<std::pair<aiTextureType, const Image*>> pictures{{aiTextureType_BASE_COLOR, &surface.colour}};
  if (!surface.lit) {
    pictures.emplace_back(aiTextureType_NORMALS, &surface.normals);
    pictures.emplace_back(aiTextureType_UNKNOWN, &surface.finish);  // what assimp calls glTF's finish
  }
  scene.mTextures = new aiTexture*[pictures.size()]();
  aiMaterial& material = *scene.mMaterials[0];
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    progress.update(double(i) / double(pictures.size()));
    scene.mTextures[i] = embedded(*pictures[i].second);
    scene.mNumTextures = unsigned(i + 1);
    const aiString name(fmt::format("*{}", i));
    material.AddProperty(&name, AI_MATKEY_TEXTURE(pictures[i].first, 0));
  }
  const aiColor4D white(1, 1, 1, 1);  // factors of what the pictures say
  const float roughness = surface.lit ? 0.9f : 1;
  material.AddProperty(&white, 1, AI_MATKEY_BASE_COLOR);
  material.AddProperty(&white, 1, AI_MATKEY_COLOR_DIFFUSE);
  material.AddProperty(&roughness, 1, AI_MATKEY_ROUGHNESS_FACTOR);
}

Bytes texturedGlb(const TexturedMesh& surface, const Progress& progress) {
  const auto scene = assimpScene(asGltf(surface.mesh), surface.uv);
  addPictures(*scene, surface, progress);
  return glb(*scene, [&](nlohmann::json& root) {
    if (!surface.lit) return;
    root["materials"][0]["extensions"]["KHR_materials_unlit"] = nlohmann::json::object();
    root["extensionsUsed"] = {"KHR_materials_unlit"};
  });
}

// The roughness alone, as a grey picture.
Image greyRoughness(const Image& finish) {
  Image grey = finish;
  for (std::size_t i = 0; i < grey.rgba.size(); i += 4) grey.rgba[i] = grey.rgba[i + 2] = grey.rgba[i + 1];
  return grey;
}

// Kd, Ks and illum are what every reader knows; Pr and norm are those of the extension for physical materials.
std::string materialText(const std::string& stem, bool lit) {
  std::string text = "# " + meshFileHeader() + "\nnewmtl skin\n";
  if (lit) return text + "illum 0\nKd 1 1 1\nmap_Kd " + stem + "_colour.png\n";
  text += "illum 2\nKd 1 1 1\nKs 0.03 0.03 0.03\nNs 30\nPm 0\nPr 1\n";
  return text + "map_Kd " + stem + "_colour.png\nmap_Pr " + stem + "_roughness.png\nnorm " + stem +
         "_normal.png\n";
}

std::vector<std::string> writeTexturedObj(const fs::path& path, const TexturedMesh& surface,
                                          const Progress& progress) {
  OutputFolder folder(path.has_parent_path() ? path.parent_path() : fs::path("."));
  const std::string stem = path.stem().string();
  std::vector<std::string> names{path.filename().string(), stem + ".mtl"};
  const auto add = [&](const char* what, const Image& image) {
    names.push_back(fmt::format("{}_{}.png", stem, what));
    writePng(folder.file(names.back()), image);
    progress.update(0.2 * double(names.size()));
  };
  add("colour", surface.colour);
  if (!surface.lit) {
    add("normal", surface.normals);
    add("roughness", greyRoughness(surface.finish));
  }
  const std::string material = materialText(stem, surface.lit);
  writeBytes(folder.file(names[1]), material.data(), material.size());
  const Bytes bytes = obj(*assimpScene(surface.mesh, surface.uv), "\nmtllib " + names[1] + "\nusemtl skin");
  writeBytes(folder.file(names[0]), bytes.data(), bytes.size());
  progress.throwIfCancelled();
  folder.commit();
  return names;
}

}  // namespace

std::vector<std::string> writeTexturedMesh(const fs::path& path, const TexturedMesh& surface,
                                           const Progress& progress) {
  const FileFormat format = requireFormat(FileKind::texturedMesh, path);
  check(surface);
  if (format == FileFormat::obj) return writeTexturedObj(path, surface, progress);
  const Bytes bytes = texturedGlb(surface, progress.part(0, 0.9));
  progress.throwIfCancelled();
  writeBytes(path, bytes.data(), bytes.size());
  progress.update(1);
  return {path.filename().string()};
}

}  // namespace sonoskin
