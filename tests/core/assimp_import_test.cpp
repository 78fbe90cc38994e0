#include "core/io/assimp_import.h"

#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/expect_error.h"

namespace sonoskin {
namespace {

using test::expectError;

// One triangle under the root node; the scene owns it all, as assimp's importers leave it.
struct Scene : aiScene {
  Scene() {
    auto* mesh = new aiMesh;
    mesh->mNumVertices = 3;
    mesh->mVertices = new aiVector3D[3]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->mNumFaces = 1;
    mesh->mFaces = new aiFace[1];
    mesh->mFaces[0].mNumIndices = 3;
    mesh->mFaces[0].mIndices = new unsigned[3]{0, 1, 2};
    mNumMeshes = 1;
    mMeshes = new aiMesh* [1] { mesh };
    mRootNode = new aiNode;
    mRootNode->mNumMeshes = 1;
    mRootNode->mMeshes = new unsigned[1]{0};
  }
};

TEST(AssimpImport, GivesOneMeshWithTheNodesMoves) {
  Scene scene;
  scene.mRootNode->mTransformation.a4 = 5;  // along x
  const Mesh mesh = meshOf(scene, "a.glb");
  EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_TRUE(mesh.normals.empty() && mesh.cornerUvs.empty());
}

TEST(AssimpImport, ChecksWhatTheSceneRefersTo) {
  Scene part, vertex, place;
  part.mRootNode->mMeshes[0] = 7;
  expectError([&] { meshOf(part, "a.glb"); }, "part without a mesh");
  vertex.mMeshes[0]->mFaces[0].mIndices[2] = 3;
  expectError([&] { meshOf(vertex, "a.glb"); }, "triangle without vertices");
  place.mRootNode->mTransformation.a4 = std::numeric_limits<float>::infinity();
  expectError([&] { meshOf(place, "a.glb"); }, "no finite position");
}

}  // namespace
}  // namespace sonoskin
