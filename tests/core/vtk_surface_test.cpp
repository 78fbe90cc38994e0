#include <gtest/gtest.h>

#include "core/io/mesh_reader.h"
#include "core/io/meshes/vtk_surface_reader.h"
#include "tests/support/expect_error.h"
#include "tests/support/logged.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::TempFolder;
using test::warningsOf;

Mesh readText(const std::string& text) {
  const TempFolder folder;
  return readMesh(folder.write("a.vtk", text));
}

std::string head(const std::string& title = "a square", const std::string& form = "ASCII") {
  return "# vtk DataFile Version 3.0\n" + title + "\n" + form + "\nDATASET POLYDATA\n";
}

const std::string kPoints = "POINTS 4 float\n0 0 0 10 0 0 10 10 0\n0 10 0\n";

void expectSquare(const Mesh& mesh, const char* what, float side = 10) {
  EXPECT_EQ(mesh.positions.size(), 4u) << what;
  EXPECT_EQ(mesh.triangles.size(), 2u) << what;
  EXPECT_EQ(mesh.positions[2], glm::vec3(side, side, 0)) << what;
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1)) << what;
}

template <class T>
std::string bigEndian(const std::vector<T>& values) {
  std::string bytes;
  for (const T& value : values) {
    std::string raw(reinterpret_cast<const char*>(&value), sizeof value);
    bytes.append(raw.rbegin(), raw.rend());
  }
  return bytes;
}

TEST(ReadVtkSurface, TextBinaryAndEitherVersion) {
  expectSquare(readText(head() + kPoints + "POLYGONS 1 5\n4 0 1 2 3\nPOINT_DATA 4\nSCALARS a float\n"),
               "text");
  expectSquare(readText(head() + kPoints + "METADATA\nINFORMATION 0\n\nPOLYGONS 2 8\n3 0 1 2\n3 0 2 3\n"),
               "triangles");
  expectSquare(readText(head() + kPoints + "TRIANGLE_STRIPS 1 5\n4 0 1 3 2\n"), "a strip");
  expectSquare(readText(head() + kPoints +
                        "POLYGONS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3 \n"),
               "version 5");
  const std::string places = bigEndian(std::vector<double>{0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0});
  expectSquare(readText(head("a", "BINARY") + "POINTS 4 double\n" + places + "\nPOLYGONS 1 5\n" +
                        bigEndian(std::vector<std::int32_t>{4, 0, 1, 2, 3}) + "\n"),
               "binary");
  expectSquare(
      readText(head("a", "BINARY") + "POINTS 4 double\n" + places + "\nPOLYGONS 2 4\nOFFSETS vtktypeint64\n" +
               bigEndian(std::vector<std::int64_t>{0, 4}) + "\nCONNECTIVITY vtktypeint64\n" +
               bigEndian(std::vector<std::int64_t>{0, 1, 2, 3}) + "\n"),
      "binary of version 5");
}

TEST(ReadVtkSurface, TheFrameOfTheTitle) {
  expectSquare(readText(head("3D Slicer output. SPACE=RAS") + kPoints + "POLYGONS 1 5\n4 0 1 2 3\n"), "RAS",
               -10);
  expectSquare(readText(head("3D Slicer output. SPACE=LPS") + kPoints + "POLYGONS 1 5\n4 0 1 2 3\n"), "LPS");
}

TEST(ReadVtkSurface, IsKnownByItsFirstLines) {
  const TempFolder folder;
  EXPECT_TRUE(isVtkSurface(folder.write("a.vtk", head())));
  EXPECT_FALSE(isVtkSurface(
      folder.write("b.vtk", "# vtk DataFile Version 3.0\na\nASCII\nDATASET STRUCTURED_POINTS\n")));
  EXPECT_FALSE(isVtkSurface(folder.write("a.nrrd", head())));
  EXPECT_FALSE(isVtkSurface(folder / "missing.vtk"));
}

TEST(ReadVtkSurface, SaysWhatIsWrong) {
  expectError([] { readText(head() + kPoints + "POLYGONS 1 5\n4 0 1 2 4\n"); }, "damaged");
  expectError([] { readText(head() + kPoints + "POLYGONS 1 5\n9 0 1 2 3\n"); }, "damaged");
  expectError([] { readText(head() + kPoints + "POLYGONS 1 5\n4 0 1\n"); }, "damaged");
  expectError([] { readText(head() + "POINTS 4000000000 float\n0 0 0\n"); }, "damaged");
  expectError([] { readText(head() + "POINTS 1 float\nnan 0 0\n"); }, "no finite position");
  expectError([] { readText(head() + kPoints + "LINES 1 3\n2 0 1\n"); }, "holds no triangles");
  EXPECT_EQ(
      warningsOf([] { readText(head() + kPoints + "LINES 1 3\n2 0 1\nPOLYGONS 1 5\n4 0 1 2 3\n"); }).size(),
      1u);
}

}  // namespace
}  // namespace sonoskin
