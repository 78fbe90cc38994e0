#include "core/io/mesh_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "core/io/file_formats.h"
#include "core/io/mesh_writer.h"
#include "tests/support/expect_error.h"
#include "tests/support/meshes.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::fileText;
using test::icosphere;
using test::TempFolder;

// A square as one polygon, with elements and properties that a Mesh does not have.
std::string squarePly(const std::string& comment = "") {
  return "ply\nformat ascii 1.0\ncomment " + comment +
         "\nelement material 1\nproperty list uchar float shades\n"
         "element vertex 4\nproperty float x\nproperty uchar red\nproperty double y\nproperty float z\n"
         "element face 1\nproperty int flags\nproperty list uchar int vertex_index\nend_header\n"
         "2 0.5 0.25\n0 9 0 1\n2 9 0 1\n2 9 3 1\n0 9 3 1\n7 4 0 1 2 3\n";
}

TEST(ReadPly, ReadsTextSkipsWhatItDoesNotKnowAndSplitsPolygons) {
  const TempFolder folder;
  const Mesh mesh = readMesh(folder.write("a.ply", squarePly()));
  ASSERT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.positions[2], glm::vec3(2, 3, 1));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.triangles[1], (Triangle{0, 2, 3}));
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
  EXPECT_TRUE(mesh.visibility.empty());
}

TEST(ReadPly, ReadsBigEndian) {
  const TempFolder folder;
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
      "short z\n"
      "element face 1\nproperty list uchar ushort vertex_indices\nend_header\n";
  for (const auto& [x, y, z] : {std::tuple{0.f, 0.f, 5}, {1.5f, 0.f, -3}, {0.f, -2.f, 258}}) {
    for (const float v : {x, y}) {
      std::uint32_t bits;
      std::memcpy(&bits, &v, 4);
      for (const int shift : {24, 16, 8, 0}) bytes += char(bits >> shift);
    }
    bytes += char(z >> 8);
    bytes += char(z);
  }
  bytes += std::string("\3\0\0\0\2\0\1", 7);
  const Mesh mesh = readMesh(folder.write("a.ply", bytes));
  EXPECT_EQ(mesh.positions[1], glm::vec3(1.5f, 0, -3));
  EXPECT_EQ(mesh.positions[2], glm::vec3(0, -2, 258));
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 2, 1}));
}

// As the Stanford scans are kept.
TEST(ReadPly, ReadsStripsOfTriangles) {
  const TempFolder folder;
  const Mesh mesh = readMesh(folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 3\n"));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {0, 1, 3}}));
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
}

TEST(ReadPly, SaysWhatItsElementsLack) {
  const TempFolder folder;
  const auto with = [&](const std::string& what, const std::string& by) {
    std::string text = squarePly();
    text.replace(text.find(what), what.size(), by);
    return folder.write("a.ply", text);
  };
  expectError([&] { readMesh(with("float z", "float depth")); }, "x, y and z are not all there");
  expectError([&] { readMesh(with("int vertex_index", "int corners")); }, "list no vertex_indices");
  expectError([&] { readMesh(with("format ascii 1.0", "format ascii8 1.0")); }, "not a complete PLY");
}

TEST(ReadMesh, ObeysTheFrameInTheHeader) {
  const TempFolder folder;
  const Mesh mesh = readMesh(folder.write("a.ply", squarePly("3D Slicer output. SPACE=RAS")));
  EXPECT_EQ(mesh.positions[2], glm::vec3(-2, -3, 1));
  const Mesh obj = readMesh(folder.write("a.obj", "# SPACE=RAS\nv 1 2 3\nv 4 5 6\nv 7 1 9\nf 1 2 3\n"));
  EXPECT_EQ(obj.positions[0], glm::vec3(-1, -2, 3));
}

TEST(ReadMesh, JoinsWhatTexturesSplit) {
  const TempFolder folder;
  const Mesh mesh =
      readMesh(folder.write("a.obj",
                            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.5\n"
                            "g one\nf 1/1 2/2 3/3\ng two\nf 1/4 3/2 4/1\n"));
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.normals.size(), 4u);
}

// Of a triangle whose second vertex has these values beside its place.
std::string trianglePly(const std::string& values) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  for (const char* name : {"nx", "ny", "nz", "visibility", "measured", "s", "t"})
    text += std::string("property float ") + name + "\n";
  return text +
         "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0 0 1 0 0.5 0.25 0 0\n1 0 "
         "0 " +
         values + "\n0 1 0 0 1 0 1 1 1 1\n3 0 1 2\n";
}

TEST(ReadPly, ValuesBesidePlacesAreWhatAMeshPromises) {
  const TempFolder folder;
  const Mesh good = readMesh(folder.write("a.ply", trianglePly("0 3 4 0.75 1 1 0")));
  EXPECT_EQ(good.normals[0], glm::vec3(0, 1, 0));
  EXPECT_LT(glm::distance(good.normals[1], glm::vec3(0, 0.6f, 0.8f)), 1e-6f);
  EXPECT_EQ(good.cornerUvs.size(), 1u);
  for (const std::string normal : {"nan 0 1", "0 0 0", "inf 0 0", "1e38 1e38 0"}) {
    const Mesh mesh = readMesh(folder.write("b.ply", trianglePly(normal + " 1 1 0 0")));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, 1)) << normal;
  }
  const Mesh mesh = readMesh(folder.write("c.ply", trianglePly("0 0 1 nan nan inf 0")));
  EXPECT_EQ(mesh.visibility, (std::vector<float>{0.5f, 0, 1}));
  EXPECT_EQ(mesh.measured, (std::vector<float>{0.25f, 0, 1}));
  EXPECT_TRUE(mesh.cornerUvs.empty());
  EXPECT_EQ(readMesh(folder.write("d.ply", trianglePly("0 0 1 -3 7 0 0"))).measured[1], 1);
}

TEST(ReadMesh, TheUnitOfAGlbCountsForItsExtent) {
  const TempFolder folder;
  writeMesh(folder / "a.glb", icosphere(1, 1000, {}));
  EXPECT_NEAR(boundingBox(readMesh(folder / "a.glb").positions).max.x, 1000, 1);
  Mesh large = icosphere(1, 1, {});
  for (glm::vec3& p : large.positions) p *= 2e5f;
  writeMesh(folder / "b.glb", large);
  expectError([&] { readMesh(folder / "b.glb"); }, "no surface of a body");
}

TEST(ReadMesh, RefusesWhatIsNoSurface) {
  const TempFolder folder;
  expectError([&] { readMesh(folder / "none.ply"); }, "no file");
  expectError([&] { readMesh(folder.write("a.xyz", "1 2 3")); }, "is not a mesh");
  expectError([&] { readMesh(folder.write("a.obj", "v 0 0 0\n")); }, "");
  for (const std::string& extension : extensionsOf(FileKind::readMesh)) {
    expectError([&] { readMesh(folder.write("empty" + extension, "")); }, "empty");
    expectError([&] { readMesh(folder.write("junk" + extension, "what is this?\n")); }, "");
  }
  std::string far = squarePly();
  far.replace(far.find("7 4 0 1 2 3"), 11, "7 4 0 1 2 4");
  expectError([&] { readMesh(folder.write("far.ply", far)); }, "a triangle without vertices");
}

TEST(ReadPly, SaysWhatIsWrongWithAPlace) {
  const TempFolder folder;
  const auto withPlace = [&](const std::string& place) {
    std::string text = trianglePly("0 0 1 1 1 0 0");
    text.replace(text.find("1 0 0 0 0 1"), 5, place);
    return folder.write("a.ply", text);
  };
  expectError([&] { readMesh(withPlace("nan 0 0")); }, "no finite position");
  expectError([&] { readMesh(withPlace("1e30 0 0")); }, "1e+27 m across");
  expectError([&] { readMesh(withPlace("-inf 0 0")); }, "no finite position");
}

TEST(ReadMesh, RefusesHugeCountsAtOnce) {
  const TempFolder folder;
  std::string ply = squarePly();
  ply.replace(ply.find("vertex 4"), 8, "vertex 18446744073709551615");
  expectError([&] { readMesh(folder.write("a.ply", ply)); }, "damaged");
  writeMesh(folder / "a.ply", icosphere(0, 1, {}));
  ply = fileText(folder / "a.ply");
  ply.replace(ply.find("face 20"), 7, "face 4000000000");
  expectError([&] { readMesh(folder.write("b.ply", ply)); }, "damaged");
  writeMesh(folder / "a.stl", icosphere(0, 1, {}));
  std::string stl = fileText(folder / "a.stl");
  stl[83] = '\x7f';
  expectError([&] { readMesh(folder.write("b.stl", stl)); }, "incomplete");
}

TEST(ReadMesh, FindsTruncatedFiles) {
  const TempFolder folder;
  for (const std::string extension : {".ply", ".stl", ".glb", ".3mf"}) {
    writeMesh(folder / ("a" + extension), icosphere(1, 1, {}));
    const std::string bytes = fileText(folder / ("a" + extension));
    for (const double part : {0.02, 0.5, 0.98}) {
      const auto cut =
          folder.write("b" + extension, bytes.substr(0, std::size_t(part * double(bytes.size()))));
      expectError([&] { readMesh(cut); }, "");
    }
  }
}

TEST(ReadMesh, StopsWhenCancelled) {
  const TempFolder folder;
  ProgressSink sink;
  sink.report = [&](double) { sink.cancel = true; };
  EXPECT_THROW(readMesh(folder.write("a.ply", squarePly()), Progress(sink)), Cancelled);
}

TEST(ReadPly, SurvivesRandomDamage) {
  const TempFolder folder;
  std::mt19937 random(42);
  writeMesh(folder / "a.ply", icosphere(0, 1, {}));
  int refused = 0;
  for (const std::string& good : {fileText(folder / "a.ply"), squarePly()})
    for (int round = 0; round < 300; ++round) {
      std::string bytes = good;
      const auto flips = 1 + random() % 4;
      for (unsigned f = 0; f < flips; ++f) bytes[random() % bytes.size()] = char(random());
      try {
        readMesh(folder.write("b.ply", bytes));
      } catch (const Error&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, 100);
}

TEST(ReadMesh, HeadsOnThisMachine) {
  const std::filesystem::path data = SONOSKIN_SHARED_DATA;
  if (!std::filesystem::is_directory(data)) GTEST_SKIP() << "the surfaces are not on this machine";
  const Mesh baby = readMesh(data / "heads/makehuman_baby/baby_head_avg_avg.obj");
  EXPECT_EQ(baby.positions.size(), 4762u);
  EXPECT_EQ(baby.triangles.size(), 9444u);
  const Box box = boundingBox(baby.positions);
  EXPECT_NEAR(box.max.x - box.min.x, 154.9, 0.1);
  EXPECT_EQ(readMesh(data / "heads/leeperrysmith/LeePerrySmith.obj").positions.size(), 8838u);
  // Packed with Draco, which moves and joins a few vertices; GLB is taken as metres.
  const Mesh packed = readMesh(data / "heads/leeperrysmith/LeePerrySmith_draco.glb");
  EXPECT_NEAR(double(packed.triangles.size()), 17672, 30);
  EXPECT_NEAR(boundingBox(packed.positions).max.z - boundingBox(packed.positions).min.z, 7946.8, 1);
}

TEST(ReadMesh, TextureCoordinatesBelongToCornersAndSurviveJoinedVertices) {
  const TempFolder folder;
  // Two triangles at an edge, with other coordinates on either side of it.
  const Mesh obj = readMesh(folder.write("a.obj",
                                         "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0.5 0\nvt 0.5 0.25\n"
                                         "vt 0.6 0.5\nvt 1 1\nvt 0.6 1\nf 1/1 2/2 3/3\nf 1/4 3/5 4/6\n"));
  EXPECT_EQ(obj.positions.size(), 4u);
  ASSERT_EQ(obj.cornerUvs.size(), 2u);
  EXPECT_EQ(obj.cornerUvs[0][2], glm::vec2(0.5f, 0.25f));
  EXPECT_EQ(obj.cornerUvs[1][0], glm::vec2(0.6f, 0.5f));
  const Mesh ply = readMesh(folder.write("b.ply",
                                         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                         "property float y\nproperty float z\nproperty float texture_u\n"
                                         "property float texture_v\nelement face 1\n"
                                         "property list uchar int vertex_index\nend_header\n"
                                         "0 0 0 0 0.5\n1 0 0 1 0.5\n1 1 0 1 1\n3 0 1 2\n"));
  ASSERT_EQ(ply.cornerUvs.size(), 1u);
  EXPECT_EQ(ply.cornerUvs[0][1], glm::vec2(1, 0.5f));
  EXPECT_TRUE(readMesh(folder.write("c.ply", squarePly())).cornerUvs.empty());
  const Mesh half = readMesh(folder.write("d.obj",
                                          "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                          "o a\nf 1/1 2/2 3/3\no b\nf 3 2 1\n"));
  EXPECT_TRUE(half.cornerUvs.empty()) << "Coordinates of some triangles are of no use.";
}

}  // namespace
}  // namespace sonoskin
