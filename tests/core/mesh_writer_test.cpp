#include "core/io/mesh_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/io/mesh_reader.h"
#include "core/mesh/facts/mesh_doubts.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::fileText;
using test::icosphere;
using test::TempFolder;

class MeshFormat : public testing::TestWithParam<const char*> {};

TEST_P(MeshFormat, ComesBackAsItWas) {
  const TempFolder folder;
  const Mesh mesh = icosphere(2, 31.5f, {10, -20.25f, 30.125f});
  const auto path = folder / (std::string("a") + GetParam());
  writeMesh(path, mesh);
  EXPECT_EQ(folder.entries(), 1);
  const Mesh read = readMesh(path);
  const float most = path.extension() == ".3mf" ? 1e-4f : 2e-5f;  // six digits
  EXPECT_EQ(read.positions.size(), mesh.positions.size());
  ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
  // Vertices may come in another order; triangles keep theirs, and their first corners too.
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = mesh.triangles[t][c], b = read.triangles[t][c];
      ASSERT_LT(glm::distance(mesh.positions[a], read.positions[b]), most) << "triangle " << t;
      ASSERT_GT(glm::dot(mesh.normals[a], read.normals[b]), 0.99f) << "triangle " << t;
    }
}

INSTANTIATE_TEST_SUITE_P(All, MeshFormat, testing::Values(".ply", ".stl", ".obj", ".glb", ".3mf", ".vtp"));

TEST(WriteMesh, SaysUnitAndFrameInTheHeader) {
  const TempFolder folder;
  for (const char* name : {"a.ply", "a.stl", "a.obj"}) {
    writeMesh(folder / name, icosphere(0, 1, {}));
    const std::string head = fileText(folder / name).substr(0, 80 + (std::string(name) == "a.ply" ? 80 : 0));
    EXPECT_NE(head.find("units mm, SPACE=LPS"), std::string::npos) << name;
    EXPECT_FALSE(head.starts_with("solid"));
  }
  EXPECT_EQ(std::filesystem::file_size(folder / "a.stl"), 84u + 50 * 20);
}

// Who asks for another frame and unit gets them where the format leaves them open, and the header says so.
TEST(WriteMesh, InRasAndMetresWhereTheFormatLeavesThemOpen) {
  const TempFolder folder;
  const Mesh mesh = icosphere(1, 30, {10, -20, 40});
  const MeshFileOptions other{{}, {MeshFrame::ras, MeshUnit::metres}};
  for (const char* name : {"a.ply", "a.stl", "a.obj", "a.vtp", "a.glb", "a.3mf"}) {
    writeMesh(folder / name, mesh, other);
    Mesh read = readMesh(folder / name);
    const bool open = leavesPlacementOpen(*formatNamed(FileKind::writtenMesh, name));
    if (open) {
      EXPECT_NE(fileText(folder / name).find("units m, SPACE=RAS"), std::string::npos) << name;
      scaleMesh(read, 1000);
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)  // RAS is read back as LPS
      ASSERT_LT(glm::distance(mesh.positions[mesh.triangles[t][0]], read.positions[read.triangles[t][0]]),
                1e-3f)
          << name;
  }
  writeMesh(folder / "b.ply", mesh, MeshFileOptions{{}, {MeshFrame::ras, MeshUnit::millimetres}});
  const std::string text = fileText(folder / "b.ply");
  float x = 0;
  std::memcpy(&x, text.data() + text.find("end_header\n") + 11, sizeof x);
  EXPECT_EQ(x, -mesh.positions[0].x);
}

TEST(WriteMesh, PlyKeepsVisibilityAndWhatWasMeasured) {
  const TempFolder folder;
  Mesh mesh = icosphere(1, 1, {});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.visibility.push_back(float(v) / 41);
    mesh.measured.push_back(1 - float(v) / 50);
  }
  writeMesh(folder / "a.ply", mesh);
  const Mesh read = readMesh(folder / "a.ply");
  EXPECT_EQ(read.visibility, mesh.visibility);
  EXPECT_EQ(read.measured, mesh.measured);
  EXPECT_EQ(read.positions, mesh.positions);
  EXPECT_EQ(read.normals, mesh.normals);
  EXPECT_EQ(read.triangles, mesh.triangles);
}

TEST(WriteMesh, PlyKeepsLabels) {
  const TempFolder folder;
  Mesh mesh = icosphere(1, 1, {});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) mesh.labels.push_back(std::uint8_t(6 * v));
  writeMesh(folder / "a.ply", mesh);
  const Mesh read = readMesh(folder / "a.ply");
  EXPECT_EQ(read.labels, mesh.labels);
  EXPECT_EQ(read.positions, mesh.positions);
  EXPECT_TRUE(read.visibility.empty());
  mesh.labels.pop_back();
  EXPECT_THROW(writeMesh(folder / "b.ply", mesh), Error);
}

TEST(WriteMesh, GlbStandsUprightInMetres) {
  const TempFolder folder;
  Mesh mesh = icosphere(1, 100, {1, 2, 3000});  // the head is up: large z in LPS
  mesh.visibility.assign(mesh.positions.size(), 0.5f);
  writeMesh(folder / "a.glb", mesh);
  const std::string bytes = fileText(folder / "a.glb");
  std::uint32_t head[5];
  std::memcpy(head, bytes.data(), sizeof head);
  EXPECT_EQ(head[2], bytes.size());
  EXPECT_EQ(bytes.size() % 4, 0u);
  const auto json = nlohmann::json::parse(bytes.substr(20, head[3]));
  const auto& position = json["accessors"][0];
  EXPECT_NEAR(position["max"][1].get<double>(), 3.1, 0.01);
  EXPECT_NEAR(position["max"][2].get<double>(), 0.098, 0.01);
  const auto& visibility =
      json["accessors"][json["meshes"][0]["primitives"][0]["attributes"]["_VISIBILITY"].get<int>()];
  EXPECT_EQ(visibility["type"], "SCALAR");
  const auto& view = json["bufferViews"][visibility["bufferView"].get<int>()];
  const std::size_t last = view["byteOffset"].get<std::size_t>() + 41 * view["byteStride"].get<std::size_t>();
  float value = 0;
  std::memcpy(&value, bytes.data() + 28 + head[3] + last, sizeof value);
  EXPECT_EQ(value, 0.5f);
  EXPECT_EQ(json["buffers"][0]["byteLength"].get<std::size_t>() + 28 + head[3], bytes.size());
}

TEST(WriteMesh, RefusesWhatItCannotWrite) {
  const TempFolder folder;
  Mesh mesh = icosphere(0, 1, {});
  expectError([&] { writeMesh(folder / "a.fbx", mesh); }, ".ply, .stl, .glb, .obj, .3mf, .vtp or .dcm",
              Error::Kind::usage);
  expectError([&] { writeMesh(folder / "a.ply", Mesh{}); }, "no surface");
  Mesh bad = mesh;
  bad.triangles[3][1] = 12;
  expectError([&] { writeMesh(folder / "a.ply", bad); }, "does not exist");
  bad = mesh;
  bad.normals.pop_back();
  expectError([&] { writeMesh(folder / "a.ply", bad); }, "11 normals");
  bad = mesh;
  bad.positions[2].y = std::numeric_limits<float>::quiet_NaN();
  expectError([&] { writeMesh(folder / "a.stl", bad); }, "no finite position");
  EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteMesh, LeavesNothingWhenCancelled) {
  const TempFolder folder;
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(writeMesh(folder / "a.ply", icosphere(0, 1, {}), Progress(sink)), Cancelled);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace sonoskin
