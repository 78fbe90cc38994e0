#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/io/mesh_reader.h"
#include "tests/support/expect_error.h"
#include "tests/support/logged.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::TempFolder;
using test::warningsOf;

const std::string kPlaces = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\n";

// The sum of the triangles' areas and the places that the second one has.
Mesh readObjText(const std::string& text) {
  const TempFolder folder;
  return readMesh(folder.write("a.obj", text));
}

TEST(ReadObj, FacesInAllTheirForms) {
  const std::string others = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\n";
  for (const std::string face :
       {"f 1 2 3 4", "f -4 -3 -2 -1", "f 1/1 2/2 3/3 4/4", "f 1//1 2//2 3//3 4//4",
        "f 1/1/1 2/2/2 3/3/3 4/4/4", "f -4/-4/-4 -3/-3/-3 -2/-2/-2 -1/-1/-1", "f 1 2 3\nf 1 3 4",
        "fo 1 2 3 4", "f 1 2 \\\n3 4", "  f\t1 2 3 4  ", "f 1 2 3 4 # the square",
        "g one\nusemtl skin\ns 1\nf 1 2 3\no two\nf 1 3 4"}) {
    const Mesh mesh = readObjText(kPlaces + others + face + "\n");
    ASSERT_EQ(mesh.triangles.size(), 2u) << face;
    EXPECT_EQ(mesh.positions.size(), 4u) << face;
    EXPECT_FLOAT_EQ(float(surfaceArea(mesh)), 100) << face;
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1)) << face;
    EXPECT_EQ(mesh.cornerUvs.empty(),
              face.find("1/") == std::string::npos || face.find("//") != std::string::npos)
        << face;
  }
}

TEST(ReadObj, PlacesInAllTheirForms) {
  for (const std::string places : {"v 0 0 0 0.5 0.5 0.5\nv 10 0 0 1 0 0\nv 10 10 0 0 0 1\nv 0 10 0 1 1 1\n",
                                   "v 0 0 0 1.0\r\nv 1e1 +0 0 1.0\r\nv 10. 1.0E+1 0 1.0\r\nv 0 10 0 1.0\r\n",
                                   "v 0 0 0\rv 10 0 0\rv 10 10 0\rv 0 10 0\r",
                                   "\xEF\xBB\xBFv 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 99 99 99\n"}) {
    const Mesh mesh = readObjText(places + "f 1 2 3 4\n");
    EXPECT_EQ(mesh.positions.size(), 4u) << places;
    EXPECT_EQ(boundingBox(mesh.positions).max, glm::vec3(10, 10, 0)) << places;
  }
}

TEST(ReadObj, AConcaveFaceIsNotFilled) {
  // An L of area 3, from a corner whose fan would leave it.
  const Mesh mesh = readObjText("v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nf 1 2 3 4 5 6\n");
  ASSERT_EQ(mesh.triangles.size(), 4u);
  EXPECT_NEAR(surfaceArea(mesh), 3, 1e-6);
  const Mesh arrow = readObjText("v 0 0 0\nv 4 2 0\nv 0 4 0\nv 1 2 0\nf 1 2 3 4\n");
  EXPECT_NEAR(surfaceArea(arrow), 6, 1e-6);
}

// A band that winds six times, whose ears are at its two ends alone: its area is that of the shoelace formula.
TEST(ReadObj, ALongConcaveFaceIsNotFilled) {
  constexpr int kSteps = 490;
  std::vector<glm::dvec2> band;
  for (const int side : {0, 1})
    for (int n = 0; n < kSteps; ++n) {
      const double turn = 12 * M_PI * (side == 0 ? n : kSteps - 1 - n) / (kSteps - 1);
      band.push_back((1 + turn + 2 * side) * glm::dvec2(std::cos(turn), std::sin(turn)));
    }
  for (const bool reversed : {false, true}) {
    if (reversed) std::reverse(band.begin(), band.end());
    std::string text, face = "f";
    double twice = 0;
    for (std::size_t n = 0; n < band.size(); ++n) {
      const glm::dvec2 &a = band[n], &b = band[(n + 1) % band.size()];
      twice += a.x * b.y - a.y * b.x;
      text += fmt::format("v {} {} 0\n", a.x, a.y), face += fmt::format(" {}", n + 1);
    }
    const Mesh mesh = readObjText(text + face + "\n");
    EXPECT_EQ(mesh.triangles.size(), band.size() - 2);
    EXPECT_NEAR(surfaceArea(mesh), std::abs(twice) / 2, 0.01);
  }
}

TEST(ReadObj, TheFrameOfAnyComment) {
  EXPECT_EQ(readObjText("# a\n# 3D Slicer output. SPACE=RAS\n" + kPlaces + "f 1 2 3\n").positions[2],
            glm::vec3(-10, -10, 0));
  EXPECT_EQ(readObjText("# units mm, SPACE=LPS\n" + kPlaces + "f 1 2 3\n").positions[2],
            glm::vec3(10, 10, 0));
}

TEST(ReadObj, SaysWhatIsWrong) {
  expectError([] { readObjText("v 0,5 0 0\n" + kPlaces + "f 1 2 3\n"); },
              "with a point, where there should be");
  expectError([] { readObjText("v 1 2\n" + kPlaces + "f 1 2 3\n"); }, "in line 1");
  expectError([] { readObjText(kPlaces + "f 1 2 5\n"); }, "without vertices");
  expectError([] { readObjText(kPlaces + "f 1 2 0\n"); }, "in line 5");
  expectError([] { readObjText(kPlaces + "f 1 2 -9\n"); }, "without vertices");
  expectError([] { readObjText(kPlaces + "f 1 2\n"); }, "fewer than three corners");
  expectError([] { readObjText(kPlaces + "f 1 2 99999999999999999999\n"); }, "without vertices");
  expectError([] { readObjText(kPlaces + "surf 0 1 0 1 1 2 3 4\n"); }, "free-form");
  expectError([] { readObjText(kPlaces + "l 1 2 3\n"); }, "holds no triangles");
  const auto said = warningsOf([] { readObjText(kPlaces + "f 1 2 3\nl 1 2\np 3\n"); });
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("lines or points"), std::string::npos);
}

}  // namespace
}  // namespace sonoskin
