#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "core/io/mesh_reader.h"
#include "core/io/meshes/base64.h"
#include "core/mesh/facts/mesh_check.h"
#include "tests/support/expect_error.h"
#include "tests/support/gltf.h"
#include "tests/support/logged.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::GltfMaker;
using test::TempFolder;
using test::warningsOf;

const std::vector<float> kCorners{0, 0, 0, 0.01f, 0, 0, 0, 0.02f, 0, 0, 0, 0.03f};  // metres, +Y up
const std::vector<std::uint16_t> kFaces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

// A tetrahedron, turned outward, 10 mm wide, 20 mm high and 30 mm deep.
GltfMaker tetrahedron() {
  GltfMaker made;
  made.primitive()["attributes"]["POSITION"] = made.floats(kCorners, "VEC3", 3);
  made.primitive()["indices"] = made.indices(kFaces);
  return made;
}

Mesh readGlb(const GltfMaker& made) {
  const TempFolder folder;
  return readMesh(folder.write("a.glb", made.glb()));
}

// Whatever the file does with it: the tetrahedron in LPS mm, its triangles outward.
void expectTetrahedron(const GltfMaker& made, const char* what, float tolerance = 1e-4f) {
  const Mesh mesh = readGlb(made);
  ASSERT_EQ(mesh.positions.size(), 4u) << what;
  ASSERT_EQ(mesh.triangles.size(), 4u) << what;
  const Box box = boundingBox(mesh.positions);
  EXPECT_LT(glm::length(box.min - glm::vec3(0, -30, 0)), tolerance) << what;
  EXPECT_LT(glm::length(box.max - glm::vec3(10, 0, 20)), tolerance) << what;
  EXPECT_NEAR(enclosedVolume(mesh), 1000, 1) << what;
}

TEST(ReadGltf, PlainAndFromText) {
  expectTetrahedron(tetrahedron(), "GLB");
  GltfMaker made = tetrahedron();
  const TempFolder folder;
  const std::vector<std::uint8_t> bytes(made.bytes.begin(), made.bytes.end());
  made.root["buffers"].push_back(
      {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + toBase64(bytes)}});
  EXPECT_EQ(readMesh(folder.write("a.gltf", made.root.dump())).triangles.size(), 4u);
  made.root["buffers"][0]["uri"] = "a%20b.bin";
  folder.write("a b.bin", made.bytes);
  EXPECT_EQ(readMesh(folder.write("b.gltf", made.root.dump())).triangles.size(), 4u);
  made.root["buffers"][0]["uri"] = "missing.bin";
  expectError([&] { readMesh(folder.write("c.gltf", made.root.dump())); }, "that is not beside it");
  made.root["buffers"][0]["uri"] = "../a.bin";
  expectError([&] { readMesh(folder.write("d.gltf", made.root.dump())); }, "outside of its own folder");
}

// Integers and the node's scale that makes metres of them. [KHR_mesh_quantization]
TEST(ReadGltf, QuantizedPlaces) {
  GltfMaker made;
  made.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  const std::vector<std::int16_t> places{0, 0, 0, 0, 10, 0, 0, 0, 0, 20, 0, 0, 0, 0, 30, 0};
  made.primitive()["attributes"]["POSITION"] =
      made.accessor(made.view(GltfMaker::bytesOf(places), 8), 5122, "VEC3", 4);
  made.primitive()["indices"] = made.indices(kFaces);
  made.node()["scale"] = {0.001, 0.001, 0.001};
  expectTetrahedron(made, "shorts");
  made.root["accessors"][0]["normalized"] = true;
  made.node()["scale"] = {32.767, 32.767, 32.767};
  expectTetrahedron(made, "normalised shorts");
}

TEST(ReadGltf, PackedByMeshoptimizer) {
  GltfMaker made;
  made.root["extensionsRequired"] = {"EXT_meshopt_compression"};
  const auto packed = [&](const std::vector<unsigned char>& bytes, nlohmann::json facts) {
    const std::size_t view = made.view({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    facts["buffer"] = 0;
    facts["byteOffset"] = made.root["bufferViews"][view]["byteOffset"];
    facts["byteLength"] = bytes.size();
    made.root["bufferViews"][view]["extensions"]["EXT_meshopt_compression"] = facts;
    return view;
  };
  std::vector<unsigned char> places(meshopt_encodeVertexBufferBound(4, 12));
  places.resize(meshopt_encodeVertexBuffer(places.data(), places.size(), kCorners.data(), 4, 12));
  std::vector<unsigned char> faces(meshopt_encodeIndexBufferBound(12, 4));
  faces.resize(meshopt_encodeIndexBuffer(faces.data(), faces.size(), kFaces.data(), 12));
  made.primitive()["attributes"]["POSITION"] = made.accessor(
      packed(places, {{"count", 4}, {"byteStride", 12}, {"mode", "ATTRIBUTES"}}), 5126, "VEC3", 4);
  made.primitive()["indices"] = made.accessor(
      packed(faces, {{"count", 12}, {"byteStride", 2}, {"mode", "TRIANGLES"}}), 5123, "SCALAR", 12);
  expectTetrahedron(made, "meshopt");
  made.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["count"] = 4000000000u;
  expectError([&] { readGlb(made); }, "damaged");
}

TEST(ReadGltf, SparseAndInterleaved) {
  GltfMaker sparse = tetrahedron();
  std::vector<float> wrong = kCorners;
  wrong[3] = 99;
  sparse.primitive()["attributes"]["POSITION"] = sparse.floats(wrong, "VEC3", 3);
  sparse.root["accessors"].back()["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", sparse.view(std::string("\1", 1))}, {"componentType", 5121}}},
      {"values", {{"bufferView", sparse.view(GltfMaker::bytesOf(std::vector<float>{0.01f, 0, 0}))}}}};
  expectTetrahedron(sparse, "sparse");

  GltfMaker woven;
  std::vector<float> both;
  for (std::size_t v = 0; v < 4; ++v) {
    both.insert(both.end(), {kCorners[3 * v], kCorners[3 * v + 1], kCorners[3 * v + 2]});
    both.insert(both.end(), {0, 1, 0, 0.5f, 0.25f});
  }
  const std::size_t view = woven.view(GltfMaker::bytesOf(both), 32);
  woven.primitive()["attributes"]["POSITION"] = woven.accessor(view, 5126, "VEC3", 4);
  woven.primitive()["attributes"]["NORMAL"] = woven.accessor(view, 5126, "VEC3", 4);
  woven.root["accessors"][1]["byteOffset"] = 12;
  woven.primitive()["indices"] = woven.indices(kFaces);
  expectTetrahedron(woven, "interleaved");
  EXPECT_EQ(readGlb(woven).normals[0], glm::vec3(0, 0, 1));
}

TEST(ReadGltf, NodesMoveTurnAndMirror) {
  GltfMaker made = tetrahedron();
  made.root["nodes"] = nlohmann::json::parse(
      R"([{"children": [1], "matrix": [0,0,-2,0, 0,2,0,0, 2,0,0,0, 0,0,0,1]},
          {"mesh": 0, "translation": [1,0,0], "rotation": [0,0.70710678118,0,0.70710678118], "scale": [0.5,0.5,0.5]}])");
  // A quarter about +Y twice, 1 m along x between them: x -> -x, z -> -z, and the place of 1 m along x.
  const Box box = boundingBox(readGlb(made).positions);
  EXPECT_LT(glm::length(box.min - glm::vec3(-10, 2000, 0)), 1e-3f);
  EXPECT_LT(glm::length(box.max - glm::vec3(0, 2030, 20)), 1e-3f);
  GltfMaker mirrored = tetrahedron();
  std::vector<float> turned = kCorners;
  turned[3] = -0.01f;
  mirrored.primitive()["attributes"]["POSITION"] = mirrored.floats(turned, "VEC3", 3);
  std::vector<std::uint16_t> faces = kFaces;
  for (std::size_t f = 0; f < faces.size(); f += 3) std::swap(faces[f + 1], faces[f + 2]);
  mirrored.primitive()["indices"] = mirrored.indices(faces);
  mirrored.node()["scale"] = {-1, 1, 1};
  expectTetrahedron(mirrored, "mirrored");
}

TEST(ReadGltf, StripsFansAndNoIndices) {
  GltfMaker made = tetrahedron();
  made.primitive()["mode"] = 5;
  made.primitive()["indices"] = made.indices({1, 3, 0, 2, 1, 3});
  expectTetrahedron(made, "strip");
  GltfMaker fan = tetrahedron();
  fan.primitive()["mode"] = 6;
  fan.primitive()["indices"] = fan.indices({3, 0, 1, 2, 0});
  EXPECT_EQ(readGlb(fan).triangles.size(), 3u);
  GltfMaker soup = tetrahedron();
  std::vector<float> corners;
  for (const std::uint16_t v : kFaces)
    corners.insert(corners.end(), {kCorners[3 * v], kCorners[3 * v + 1], kCorners[3 * v + 2]});
  soup.primitive()["attributes"]["POSITION"] = soup.floats(corners, "VEC3", 3);
  soup.primitive().erase("indices");
  expectTetrahedron(soup, "without indices");
}

TEST(ReadGltf, SkeletonsAndMorphTargetsAtRest) {
  GltfMaker bent = tetrahedron();  // the bone is moved by 1 m from where the mesh was bound to it
  bent.root["nodes"] =
      nlohmann::json::parse(R"([{"mesh": 0, "skin": 0, "translation": [7,7,7]}, {"translation": [0,3,0]}])");
  bent.root["skins"] = {
      {{"joints", {1}},
       {"inverseBindMatrices", bent.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2, 0, 1}, "MAT4", 16)}}};
  bent.primitive()["attributes"]["JOINTS_0"] =
      bent.accessor(bent.view(std::string(16, '\0')), 5121, "VEC4", 4);
  bent.primitive()["attributes"]["WEIGHTS_0"] =
      bent.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4);
  EXPECT_LT(glm::length(boundingBox(readGlb(bent).positions).min - glm::vec3(0, -30, 1000)), 1e-3f);
  GltfMaker morphed = tetrahedron();
  morphed.primitive()["targets"] = {
      {{"POSITION", morphed.floats({2, 0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 0}, "VEC3", 3)}}};
  morphed.root["meshes"][0]["weights"] = {0.5};
  EXPECT_NEAR(boundingBox(readGlb(morphed).positions).min.x, 1000, 1e-3);
  morphed.node()["weights"] = {0};
  expectTetrahedron(morphed, "the node's weights hold");
}

TEST(ReadGltf, ExtensionsThatAreNotKnownAreNamed) {
  GltfMaker made = tetrahedron();
  made.root["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_basisu"};
  expectTetrahedron(made, "light and colour change no surface");
  made.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing", "KHR_animation_pointer"};
  const auto said = warningsOf([&] { expectTetrahedron(made, "used, not required"); });
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("EXT_mesh_gpu_instancing"), std::string::npos);
  made.root["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  expectError([&] { readGlb(made); }, "needs EXT_mesh_gpu_instancing");
  for (const char* name : {"Wilhelmina_Featherstone", "EXT_featherstone"}) {
    made.root["extensionsRequired"] = {name};
    expectError([&] { readGlb(made); }, "needs an extension of glTF that is not known");
  }
}

TEST(ReadGltf, WhatIsNoSurfaceIsSaid) {
  GltfMaker points = tetrahedron();
  points.primitive()["mode"] = 0;
  expectError([&] { readGlb(points); }, "points or lines alone");
  GltfMaker both = tetrahedron();
  both.root["meshes"][0]["primitives"].push_back(both.primitive());
  both.root["meshes"][0]["primitives"][1]["mode"] = 1;
  EXPECT_EQ(warningsOf([&] { expectTetrahedron(both, "beside lines"); }).size(), 1u);
  GltfMaker scenes = tetrahedron();
  scenes.root["scenes"].push_back({{"nodes", nlohmann::json::array()}});
  EXPECT_EQ(warningsOf([&] { expectTetrahedron(scenes, "two scenes"); }).size(), 1u);
}

TEST(ReadGltf, DamageIsFound) {
  const auto damage = [](const std::function<void(GltfMaker&)>& change) {
    GltfMaker made = tetrahedron();
    change(made);
    expectError([&] { readGlb(made); }, "damaged");
  };
  damage([](GltfMaker& m) { m.root["accessors"][0]["count"] = 5; });
  damage([](GltfMaker& m) { m.root["accessors"][0]["count"] = -1; });
  damage([](GltfMaker& m) { m.root["accessors"][0]["type"] = "VEC2"; });
  damage([](GltfMaker& m) { m.root["accessors"][1]["count"] = 18446744073709551615u; });
  damage([](GltfMaker& m) { m.root["bufferViews"][0]["byteOffset"] = 9999; });
  damage([](GltfMaker& m) { m.root["bufferViews"][0]["byteStride"] = 4000000000u; });
  damage([](GltfMaker& m) { m.root["bufferViews"][1]["buffer"] = 7; });
  damage([](GltfMaker& m) { m.primitive()["attributes"]["POSITION"] = 44; });
  damage([](GltfMaker& m) { m.primitive()["indices"] = m.indices({0, 1, 4}); });
  damage([](GltfMaker& m) { m.node()["children"] = {0}; });
  damage([](GltfMaker& m) { m.node()["mesh"] = 1; });
  damage([](GltfMaker& m) { m.root["buffers"].push_back({{"byteLength", 5000}}); });
  damage([](GltfMaker& m) { m.node()["rotation"] = {0, 0, 0, 0}; });
  GltfMaker old = tetrahedron();
  old.root["asset"]["version"] = "1.0";
  expectError([&] { readGlb(old); }, "version 2");
}

// A buffer that says it is long and holds nothing: no count may be believed because of it.
TEST(ReadGltf, CountsAreHeldAgainstTheBytesThatAreThere) {
  const auto refuses = [](GltfMaker made, std::uint64_t length) {
    made.root["buffers"] = {{{"byteLength", made.bytes.size()}},
                            {{"byteLength", length}, {"uri", "data:;base64,"}}};
    expectError([&] { readGlb(made); }, "no whole glTF file");
  };
  GltfMaker zeros = tetrahedron();
  zeros.root["accessors"][0].erase("bufferView");
  zeros.root["accessors"][0]["count"] = 10'000'000'000u;
  // Distances between elements that overflow: the last one seems to lie at the beginning.
  GltfMaker sparse = tetrahedron();
  const std::size_t view = sparse.view(std::string(4096, '\0'), 1024);
  sparse.root["accessors"][0]["sparse"] = {{"count", (std::uint64_t(1) << 54) + 1},
                                           {"indices", {{"bufferView", view}, {"componentType", 5121}}},
                                           {"values", {{"bufferView", view}}}};
  GltfMaker dense = tetrahedron();
  dense.root["accessors"][0]["bufferView"] = dense.view(std::string(4096, '\0'), 1024);
  dense.root["accessors"][0]["count"] = (std::uint64_t(1) << 54) + 1;
  for (const std::uint64_t length : {std::uint64_t(0), std::uint64_t(1) << 63}) {
    refuses(zeros, length);
    refuses(sparse, length);
    refuses(dense, length);
  }
}

TEST(Base64, AsTheStandardHasIt) {
  const std::vector<std::pair<std::string, std::string>> all{{"", ""},
                                                             {"f", "Zg=="},
                                                             {"fo", "Zm8="},
                                                             {"foo", "Zm9v"},
                                                             {"foob", "Zm9vYg=="},
                                                             {"fooba", "Zm9vYmE="},
                                                             {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : all) {
    const std::vector<std::uint8_t> bytes(plain.begin(), plain.end());
    EXPECT_EQ(toBase64(bytes), coded);
    EXPECT_EQ(fromBase64(coded), bytes) << coded;
  }
  for (const char* bad : {"Z", "Zg=", "Zg", "Zm9v=", "Z=g=", "Zm9*"}) EXPECT_FALSE(fromBase64(bad)) << bad;
}

}  // namespace
}  // namespace sonoskin
