#include <gtest/gtest.h>

#include <cstring>

#include "core/io/mesh_reader.h"
#include "core/io/mesh_writer.h"
#include "core/mesh/facts/mesh_doubts.h"
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

// A tetrahedron with corners at 0 and at 10 on each axis, turned outward.
std::string tetrahedron(const std::string& end = "\n") {
  const char* corners[] = {"0 0 0", "10 0 0", "0 10 0", "0 0 10"};
  std::string text = "solid a" + end;
  for (const auto& f : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    text += "  facet normal 0 0 0" + end + "    outer loop" + end;
    for (const int v : f) text += std::string("      vertex ") + corners[v] + end;
    text += "    endloop" + end + "  endfacet" + end;
  }
  return text + "endsolid a" + end;
}

std::string upperCase(std::string text) {
  for (char& c : text) c = char(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

TEST(ReadStl, TextInAllItsForms) {
  const TempFolder folder;
  const std::string plain = tetrahedron();
  const std::vector<std::pair<const char*, std::string>> forms{
      {"plain", plain},
      {"capitals", upperCase(plain)},
      {"blanks in front", "\n\t  " + plain},
      {"carriage returns", tetrahedron("\r")},
      {"both line ends", tetrahedron("\r\n")},
      {"mixed", tetrahedron("\n") + tetrahedron("\r\n")},
      {"a mark of UTF-8", "\xEF\xBB\xBF" + plain},
      {"one line", replaced(plain.substr(8), "\n", " ").insert(0, "solid a\n").append("\n")},
      {"plus signs and exponents", replaced(replaced(plain, "10 ", "+1.0E+01 "), " 10", " 1e1")},
      {"no name", replaced(plain, "solid a", "solid")},
      {"a name that holds a keyword", replaced(plain, "solid a", "solid facet vertex")},
      {"several solids", plain + replaced(plain, "solid a", "solid b")},
      {"colours", replaced(plain, "    outer loop", "color 0.5 0.5 0.5\n    outer loop")}};
  for (const auto& [name, text] : forms) {
    const Mesh mesh = readMesh(folder.write("a.stl", text));
    EXPECT_EQ(mesh.positions.size(), 4u) << name;
    EXPECT_EQ(mesh.triangles.size() % 4, 0u) << name;
    EXPECT_EQ(boundingBox(mesh.positions).max, glm::vec3(10)) << name;
    EXPECT_EQ(mesh.normals[0], glm::normalize(glm::vec3(-1))) << name;
  }
}

TEST(ReadStl, BinaryThatBeginsAsText) {
  const TempFolder folder;
  writeMesh(folder / "a.stl", icosphere(1, 20, {}));
  const std::string good = fileText(folder / "a.stl");
  for (const std::string head : {"solid face of a child", "SOLID", "solid", "COLOR=\x80\x80\x80\xff"}) {
    std::string bytes = good;
    bytes.replace(0, 80, (head + std::string(80, ' ')).substr(0, 80));
    bytes[84 + 48] = 'x';  // an attribute, such as a colour
    EXPECT_EQ(readMesh(folder.write("b.stl", bytes)).triangles.size(), 80u) << head;
    expectError([&] { readMesh(folder.write("c.stl", bytes.substr(0, 2000))); },
                "ends before all of its triangles");
  }
}

TEST(ReadStl, TheFrameIsWhereSlicerSaysIt) {
  const TempFolder folder;
  const auto highest = [&](const std::string& bytes) {
    return boundingBox(readMesh(folder.write("b.stl", bytes)).positions).max;
  };
  EXPECT_EQ(highest(replaced(tetrahedron(), "solid a", "solid 3D Slicer output. SPACE=RAS")),
            glm::vec3(0, 0, 10));
  EXPECT_EQ(highest(replaced(tetrahedron(), "solid a", "solid SPACE=LPS")), glm::vec3(10));
  writeMesh(folder / "a.stl", icosphere(1, 20, {50, 60, 70}));
  std::string bytes = fileText(folder / "a.stl");
  EXPECT_GT(highest(bytes).x, 60);
  bytes.replace(bytes.find("SPACE=LPS"), 9, "SPACE=RAS");
  EXPECT_LT(highest(bytes).x, -20);
  EXPECT_GT(highest(bytes).z, 80);
}

TEST(ReadStl, AFrameThatIsNotKnownIsWarnedOf) {
  const TempFolder folder;
  const std::string text = replaced(tetrahedron(), "solid a", "solid SPACE=Featherstone");
  const auto said = warningsOf([&] { readMesh(folder.write("a.stl", text)); });
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("neither LPS nor RAS"), std::string::npos);
  EXPECT_EQ(said[0].find("Featherstone"), std::string::npos);
}

TEST(ReadStl, SaysWhatIsWrong) {
  const TempFolder folder;
  const std::string plain = tetrahedron();
  const auto read = [&](const std::string& text) { readMesh(folder.write("a.stl", text)); };
  expectError([&] { read(replaced(plain, "10 0 0", "10,5 0 0")); }, "is no STL text in line");
  expectError([&] { read(replaced(plain, "10 0 0", "nan 0 0")); }, "no finite position");
  expectError([&] { read(replaced(plain, "outer loop", "inner loop")); }, "is no STL text in line 3");
  expectError([&] { read(plain.substr(0, plain.find("endloop"))); }, "in the middle of a triangle");
  // Without its end a triangle would run on into the next one.
  const std::size_t second = plain.find("endloop", plain.find("endloop") + 1);
  expectError([&] { read(std::string(plain).erase(second, 7)); }, "is no STL text in line 15");
  expectError([&] { read(replaced(plain, "endloop", "")); }, "is no STL text in line 8");
  expectError([&] { read("solid a\nendsolid a\n"); }, "holds no triangles");
  const auto said = warningsOf([&] { read(replaced(plain, "endsolid a\n", "")); });
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("without its last line"), std::string::npos);
}

}  // namespace
}  // namespace sonoskin
