// A scene as assimp could give it for any file, with parts, normals and texture coordinates.
#include <assimp/scene.h>

#include "core/io/assimp_import.h"
#include "core/io/loaded_mesh.h"
#include "tests/fuzz/mesh_claims.h"

using namespace sonoskin;

namespace {

using fuzz::Numbers;

aiVector3D vector(Numbers& numbers) {
  const float x = numbers.next<float>(), y = numbers.next<float>(), z = numbers.next<float>();
  return {x, y, z};
}

aiVector3D* vectors(Numbers& numbers, unsigned count) {
  auto* all = new aiVector3D[count];
  for (unsigned v = 0; v < count; ++v) all[v] = vector(numbers);
  return all;
}

// One part; the scene owns what it points to. Indices may be anything, as in a file.
aiMesh* part(Numbers& numbers) {
  auto* mesh = new aiMesh;
  mesh->mNumVertices = unsigned(numbers.between(0, 8));
  mesh->mVertices = vectors(numbers, mesh->mNumVertices);
  const int has = numbers.between(0, 3);
  if (has & 1) mesh->mNormals = vectors(numbers, mesh->mNumVertices);
  if (has & 2) mesh->mTextureCoords[0] = vectors(numbers, mesh->mNumVertices);
  mesh->mNumFaces = unsigned(numbers.between(0, 8));
  mesh->mFaces = new aiFace[mesh->mNumFaces];
  for (unsigned f = 0; f < mesh->mNumFaces; ++f) {
    aiFace& face = mesh->mFaces[f];
    face.mNumIndices = unsigned(numbers.between(1, 3));
    face.mIndices = new unsigned[face.mNumIndices];
    for (unsigned i = 0; i < face.mNumIndices; ++i) face.mIndices[i] = numbers.next<std::uint8_t>() % 10;
  }
  return mesh;
}

aiNode* node(Numbers& numbers, int depth) {
  auto* made = new aiNode;
  for (unsigned r = 0; r < 4; ++r)
    for (unsigned c = 0; c < 4; ++c) made->mTransformation[r][c] = numbers.next<float>();
  made->mNumMeshes = unsigned(numbers.between(0, 2));
  made->mMeshes = new unsigned[made->mNumMeshes];
  for (unsigned m = 0; m < made->mNumMeshes; ++m) made->mMeshes[m] = unsigned(numbers.between(0, 3));
  if (depth > 0 && numbers.between(0, 1) == 1) {
    made->mNumChildren = 1;
    made->mChildren = new aiNode* [1] { node(numbers, depth - 1) };
  }
  return made;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Numbers numbers({data, size});
  aiScene scene;
  scene.mNumMeshes = unsigned(numbers.between(1, 3));
  scene.mMeshes = new aiMesh*[scene.mNumMeshes];
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) scene.mMeshes[m] = part(numbers);
  scene.mRootNode = node(numbers, 2);
  fuzz::attempt([&] {
    Mesh mesh = meshOf(scene, "a.glb");
    settleMesh(mesh);
    checkMesh(mesh, "a.glb");
    fuzz::claimSound(mesh);
  });
  return 0;
}
