#include <gtest/gtest.h>

#include "core/io/mesh_reader.h"
#include "core/io/mesh_writer.h"
#include "core/io/meshes/base64.h"
#include "tests/support/expect_error.h"
#include "tests/support/logged.h"
#include "tests/support/meshes.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::fileText;
using test::icosphere;
using test::TempFolder;
using test::warningsOf;

Mesh readText(const std::string& text) {
  const TempFolder folder;
  return readMesh(folder.write("a.vtp", text));
}

template <class T>
std::string bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::string letters(const std::string& bytes) {
  return toBase64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

// A square of two triangles; `attributes` and `inside` of the points, which are ascii without any; `more` in the piece.
std::string square(
    const std::string& points = "type=\"Float32\" format=\"ascii\"> 0 0 0 10 0 0 10 10 0 0 10 0",
    const std::string& file = "byte_order=\"LittleEndian\"", const std::string& more = "",
    const std::string& fields = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" " + file + "><PolyData>" +
         fields +
         "<Piece NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
         "NumberOfPolys=\"1\">"
         "<PointData></PointData><Points><DataArray Name=\"Points\" NumberOfComponents=\"3\" " +
         points + "</DataArray></Points>" + more +
         "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
         "<DataArray type=\"Int32\" Name=\"offsets\" "
         "format=\"ascii\">4</DataArray></Polys></Piece></PolyData></VTKFile>";
}

const std::vector<float> kPlaces{0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0};

void expectSquare(const Mesh& mesh, const char* what) {
  EXPECT_EQ(mesh.positions.size(), 4u) << what;
  EXPECT_EQ(mesh.triangles.size(), 2u) << what;
  EXPECT_EQ(boundingBox(mesh.positions).max, glm::vec3(10, 10, 0)) << what;
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1)) << what;
}

std::string bigEndian(std::string bytes, std::size_t each) {
  for (std::size_t at = 0; at < bytes.size(); at += each)
    std::reverse(bytes.begin() + std::ptrdiff_t(at), bytes.begin() + std::ptrdiff_t(at + each));
  return bytes;
}

TEST(ReadVtp, NumbersWhereverTheyAre) {
  expectSquare(readText(square()), "text");
  const std::string values = bytesOf(kPlaces), count = bytesOf(std::vector<std::uint32_t>{48}),
                    wide = bytesOf(std::vector<std::uint64_t>{48});
  const std::string binary = "type=\"Float32\" format=\"binary\">\n";
  expectSquare(readText(square(binary + letters(count + values) + "\n")), "letters");
  expectSquare(readText(square(binary + letters(count) + letters(values))),
               "count and numbers each in letters");
  const std::string wideFile = "byte_order=\"LittleEndian\" header_type=\"UInt64\"";
  expectSquare(readText(square(binary + letters(wide + values), wideFile)), "a wide count");
  expectSquare(readText(square(binary + letters(wide) + letters(values), wideFile)),
               "a wide count by itself");
  expectSquare(readText(square(binary + letters(bigEndian(count + values, 4)), "byte_order=\"BigEndian\"")),
               "big-endian");
  std::string raw = square("type=\"Float32\" format=\"appended\" offset=\"3\">");
  const std::string end = "</VTKFile>";
  raw.replace(raw.find(end), end.size(),
              "<AppendedData encoding=\"raw\">\n_abc" + count + values + "</AppendedData></VTKFile>");
  expectSquare(readText(raw), "behind the header");
}

TEST(ReadVtp, TheFrameOfTheFieldData) {
  const auto field = [](const std::string& codes) {
    return "<FieldData><Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" format=\"ascii\">" + codes +
           "</Array></FieldData>";
  };
  const auto middle = [&](const std::string& codes) {
    return readText(square("type=\"Float32\" format=\"ascii\"> 0 0 0 10 0 0 10 10 0 0 10 0",
                           "byte_order=\"LittleEndian\"", "", field(codes)))
        .positions[2];
  };
  EXPECT_EQ(middle("82 65 83 0"), glm::vec3(-10, -10, 0));
  EXPECT_EQ(middle("76 80 83 0"), glm::vec3(10, 10, 0));
  EXPECT_EQ(warningsOf([&] { middle("82 65 84 0"); }).size(), 1u);
}

TEST(ReadVtp, StripsAndPieces) {
  std::string text = square();
  const std::size_t piece = text.find("<Piece"), end = text.find("</PolyData>");
  std::string second = text.substr(piece, end - piece);
  second.replace(second.find("<Polys>"), 7, "<Strips>");
  second.replace(second.find("</Polys>"), 8, "</Strips>");
  second.replace(second.find("0 1 2 3"), 7, "0 1 3 2");
  text.insert(end, second);
  const Mesh mesh = readText(text);
  EXPECT_EQ(mesh.positions.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.triangles[3], (Triangle{7, 5, 6}));
  for (const glm::vec3& n : mesh.normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

// What a surface may have beside its places; `inside` the element of the points' arrays.
std::string squareWith(const std::string& roles, const std::string& inside) {
  std::string text = square();
  const std::string empty = "<PointData></PointData>";
  return text.replace(text.find(empty), empty.size(), "<PointData" + roles + ">" + inside + "</PointData>");
}
std::string pointArray(const std::string& name, int components, const std::string& numbers) {
  return "<DataArray type=\"Float32\" Name=\"" + name + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"ascii\">" + numbers + "</DataArray>";
}

// Other programs give these names to arrays of their own: the surface is whole without them.
TEST(ReadVtp, ArraysOfOtherSizesAreLeftOutAndSaidSo) {
  for (const char* name : {"label", "visibility", "measured", "Normals", "TCoords"})
    for (const auto& [components, numbers] :
         {std::pair(4, "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16"), {1, "1 2 3"}, {3, "1 2 3 4 5 6 7 8 9"}}) {
      const auto said = warningsOf(
          [&] { expectSquare(readText(squareWith("", pointArray(name, components, numbers))), name); });
      ASSERT_EQ(said.size(), 1u) << name << components;
      EXPECT_NE(said[0].find("left out"), std::string::npos);
    }
  const Mesh labelled = readText(squareWith("", pointArray("label", 1, "1 2 3 4")));
  EXPECT_EQ(labelled.labels, (std::vector<std::uint8_t>{1, 2, 3, 4}));
}

TEST(ReadVtp, AnEmptyRoleIsNone) {
  const std::string speed = pointArray("speed", 3, "1 0 0 1 0 0 1 0 0 1 0 0");
  expectSquare(readText(squareWith(" Normals=\"\"", speed)), "no normals");
  EXPECT_EQ(readText(squareWith(" Normals=\"speed\"", speed)).normals[0], glm::vec3(1, 0, 0));
}

TEST(ReadVtp, SaysWhatIsWrong) {
  expectError([] { readText(square("type=\"Float32\" format=\"ascii\"> 0 0 0 10 0 0")); }, "damaged");
  expectError([] { readText(square("type=\"Float32\" format=\"ascii\"> 0 0 0 10 0 0 10 10 0 nan 10 0")); },
              "no finite");
  expectError([] { readText(square("type=\"Complex\" format=\"binary\">AAAA")); }, "damaged");
  expectError([] { readText(square("type=\"Float32\" format=\"binary\">////fwAA")); }, "damaged");
  const std::string points = "type=\"Float32\" format=\"ascii\"> 0 0 0 10 0 0 10 10 0 0 10 0";
  expectError([&] { readText(square(points, "compressor=\"vtkLZ4DataCompressor\"")); }, "LZ4");
  std::string text = square();
  text.replace(text.find("0 1 2 3"), 7, "0 1 2 4");
  expectError([&] { readText(text); }, "damaged");
  text = square();
  text.replace(text.find("PolyData\" ver"), 8, "ImageData");
  expectError([&] { readText(text); }, "of another kind");
  text = square();
  text.replace(text.find("NumberOfLines=\"0\""), 17, "NumberOfLines=\"2\"");
  EXPECT_EQ(warningsOf([&] { readText(text); }).size(), 1u);
}

TEST(WriteVtp, KeepsAllThatAMeshHas) {
  const TempFolder folder;
  Mesh mesh = icosphere(4, 31.5f, {10, -20.25f, 30.125f});
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.visibility.push_back(float(v % 7) / 7);
    mesh.measured.push_back(float(v % 5) / 5);
    mesh.labels.push_back(std::uint8_t(v % 250));
  }
  writeMesh(folder / "a.vtp", mesh);
  const Mesh read = readMesh(folder / "a.vtp");
  EXPECT_EQ(read.positions, mesh.positions);
  EXPECT_EQ(read.normals, mesh.normals);
  EXPECT_EQ(read.triangles, mesh.triangles);
  EXPECT_EQ(read.visibility, mesh.visibility);
  EXPECT_EQ(read.measured, mesh.measured);
  EXPECT_EQ(read.labels, mesh.labels);
  const std::string text = fileText(folder / "a.vtp");
  EXPECT_NE(text.find("Name=\"SPACE\""), std::string::npos);
  for (const double part : {0.1, 0.5, 0.9, 0.99})
    expectError(
        [&] { readMesh(folder.write("b.vtp", text.substr(0, std::size_t(part * double(text.size()))))); },
        "");
}

}  // namespace
}  // namespace sonoskin
