#include "core/io/textured_mesh_writer.h"

#include <assimp/GltfMaterial.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Importer.hpp>
#include <fstream>

#include "core/io/mesh_reader.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::fileText;
using test::TempFolder;

Image plainImage(int width, int height, std::array<std::uint8_t, 3> colour) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    image.rgba.insert(image.rgba.end(), {colour[0], colour[1], colour[2], 255});
  return image;
}

// A square of two triangles that faces the probe (-y), 20 mm wide; its lower left pixel is red.
TexturedMesh square() {
  TexturedMesh s;
  s.mesh.positions = {{0, 5, 100}, {20, 5, 100}, {20, 5, 120}, {0, 5, 120}};
  s.mesh.normals.assign(4, {0, -1, 0});
  s.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  s.uv = {{0, 0}, {1, 0}, {1, 0.5f}, {0, 0.5f}};
  s.colour = plainImage(8, 4, {10, 20, 30});
  s.colour.rgba[4 * 8 * 3] = 250;
  s.normals = plainImage(8, 4, {128, 128, 255});
  s.finish = plainImage(4, 4, {0, 90, 0});
  return s;
}

Image pictureOf(const aiScene& scene, aiTextureType type, const TempFolder& folder) {
  aiString name;
  const aiMaterial& material = *scene.mMaterials[scene.mMeshes[0]->mMaterialIndex];
  EXPECT_EQ(material.GetTexture(type, 0, &name), aiReturn_SUCCESS);
  const aiTexture* texture = scene.GetEmbeddedTexture(name.C_Str());
  if (!texture) return readPng(folder / name.C_Str());
  EXPECT_EQ(texture->mHeight, 0u);
  std::ofstream(folder / "picture.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(texture->pcData), texture->mWidth);
  return readPng(folder / "picture.png");
}

void expectCoordinates(const aiMesh& part) {
  ASSERT_EQ(part.mNumVertices, 4u);
  ASSERT_TRUE(part.HasTextureCoords(0));
  int found = 0;
  for (unsigned v = 0; v < 4; ++v) {
    const aiVector3D at = part.mTextureCoords[0][v];
    const bool right = part.mVertices[v].x > 0;
    EXPECT_FLOAT_EQ(at.x, right ? 1 : 0);
    found += at.y == 0 ? 1 : 10;
    EXPECT_TRUE(at.y == 0 || at.y == 0.5f) << at.y;
  }
  EXPECT_EQ(found, 22);
}

TEST(WriteTexturedMesh, GlbHoldsCoordinatesAndPictures) {
  const TempFolder folder;
  const TexturedMesh s = square();
  writeTexturedMesh(folder / "a.glb", s);
  EXPECT_EQ(folder.entries(), 1);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile((folder / "a.glb").string(), 0);
  ASSERT_TRUE(scene && scene->mNumMeshes == 1) << importer.GetErrorString();
  expectCoordinates(*scene->mMeshes[0]);
  EXPECT_NEAR(scene->mMeshes[0]->mVertices[1].x, 0.02f, 1e-6f) << "metres";
  EXPECT_EQ(pictureOf(*scene, aiTextureType_BASE_COLOR, folder).rgba, s.colour.rgba);
  EXPECT_EQ(pictureOf(*scene, aiTextureType_NORMALS, folder).rgba, s.normals.rgba);
  EXPECT_EQ(pictureOf(*scene, aiTextureType_METALNESS, folder).rgba, s.finish.rgba);
  aiColor4D factor;
  ASSERT_EQ(scene->mMaterials[0]->Get(AI_MATKEY_BASE_COLOR, factor), aiReturn_SUCCESS);
  EXPECT_EQ(factor, aiColor4D(1, 1, 1, 1)) << "the pictures are not tinted";
  float roughness = 0;
  ASSERT_EQ(scene->mMaterials[0]->Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness), aiReturn_SUCCESS);
  EXPECT_EQ(roughness, 1);
  EXPECT_EQ(fileText(folder / "a.glb").find("unlit"), std::string::npos);
}

TEST(WriteTexturedMesh, LightThatIsBakedIsNotLitAgain) {
  const TempFolder folder;
  TexturedMesh s = square();
  s.lit = true;
  s.normals = s.finish = {};
  writeTexturedMesh(folder / "a.glb", s);
  const std::string text = fileText(folder / "a.glb");
  EXPECT_NE(text.find("\"extensionsUsed\":[\"KHR_materials_unlit\"]"), std::string::npos);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile((folder / "a.glb").string(), 0);
  ASSERT_TRUE(scene) << importer.GetErrorString();
  EXPECT_EQ(scene->mNumTextures, 1u);
  int shading = 0;
  ASSERT_EQ(scene->mMaterials[0]->Get(AI_MATKEY_SHADING_MODEL, shading), aiReturn_SUCCESS);
  EXPECT_EQ(shading, aiShadingMode_Unlit);
}

TEST(WriteTexturedMesh, ObjNamesItsMaterialAndPictures) {
  const TempFolder folder;
  const TexturedMesh s = square();
  const std::vector<std::string> files = writeTexturedMesh(folder / "a.obj", s);
  EXPECT_EQ(files,
            (std::vector<std::string>{"a.obj", "a.mtl", "a_colour.png", "a_normal.png", "a_roughness.png"}));
  EXPECT_EQ(folder.entries(), 5);
  for (const std::string& file : files) EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  EXPECT_TRUE(fileText(folder / "a.obj").starts_with("# Sonoskin"));
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile((folder / "a.obj").string(), aiProcess_JoinIdenticalVertices);
  ASSERT_TRUE(scene && scene->mNumMeshes == 1) << importer.GetErrorString();
  expectCoordinates(*scene->mMeshes[0]);
  EXPECT_EQ(pictureOf(*scene, aiTextureType_DIFFUSE, folder).rgba, s.colour.rgba);
  EXPECT_EQ(readPng(folder / "a_normal.png").rgba, s.normals.rgba);
  EXPECT_EQ(readPng(folder / "a_roughness.png").rgba[0], 90);
  EXPECT_EQ(readMesh(folder / "a.obj").positions.size(), 4u);

  TexturedMesh lit = s;
  lit.lit = true;
  writeTexturedMesh(folder / "b.obj", lit);
  EXPECT_EQ(folder.entries(), 8);
  EXPECT_EQ(fileText(folder / "b.mtl").find("norm"), std::string::npos);
}

TEST(WriteTexturedMesh, RefusesWhatDoesNotFit) {
  const TempFolder folder;
  expectError([&] { writeTexturedMesh(folder / "a.ply", square()); }, ".glb", Error::Kind::usage);
  TexturedMesh s = square();
  s.uv.pop_back();
  expectError([&] { writeTexturedMesh(folder / "a.glb", s); }, "for every vertex");
  s = square();
  s.normals = {};
  expectError([&] { writeTexturedMesh(folder / "a.obj", s); }, "normals");
  s = square();
  s.mesh.triangles[1][2] = 4;
  expectError([&] { writeTexturedMesh(folder / "a.obj", s); }, "does not exist");
  EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteTexturedMesh, LeavesNothingWhenCancelled) {
  const TempFolder folder;
  ProgressSink sink;
  sink.cancel = true;
  for (const char* name : {"a.glb", "a.obj"})
    EXPECT_THROW(writeTexturedMesh(folder / name, square(), Progress(sink)), Cancelled);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace sonoskin
