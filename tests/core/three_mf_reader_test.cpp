#include <gtest/gtest.h>

#include "core/io/mesh_reader.h"
#include "core/mesh/facts/mesh_check.h"
#include "tests/support/expect_error.h"
#include "tests/support/logged.h"
#include "tests/support/temp_folder.h"
#include "tests/support/zip.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::TempFolder;
using test::warningsOf;
using test::zipOf;

const std::string kCore = "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"";
const std::string kProduction = "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"";

// A tetrahedron with corners at 0 and at 10 on each axis, turned outward.
std::string object(const std::string& id, const std::string& attributes = "type=\"model\"") {
  std::string text = "<object id=\"" + id + "\" " + attributes + "><mesh><vertices>";
  for (const char* v : {"x=\"0\" y=\"0\" z=\"0\"", "x=\"10\" y=\"0\" z=\"0\"", "x=\"0\" y=\"10\" z=\"0\"",
                        "x=\"0\" y=\"0\" z=\"10\""})
    text += std::string("<vertex ") + v + "/>";
  text += "</vertices><triangles>";
  for (const char* t : {"v1=\"0\" v2=\"2\" v3=\"1\"", "v1=\"0\" v2=\"1\" v3=\"3\"",
                        "v1=\"0\" v2=\"3\" v3=\"2\"", "v1=\"1\" v2=\"2\" v3=\"3\""})
    text += std::string("<triangle ") + t + "/>";
  return text + "</triangles></mesh></object>";
}

std::string model(const std::string& objects, const std::string& build, const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?>\n<model " + kCore + " " + kProduction + " " + attributes + "><resources>" +
         objects + "</resources><build>" + build + "</build></model>";
}

std::string file(const std::string& xml,
                 const std::vector<std::pair<std::string, std::string>>& others = {}) {
  std::vector<std::pair<std::string, std::string>> parts{
      {"_rels/.rels",
       "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
       "Target=\"/3D/face.model\" Id=\"r\" "
       "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
       "</Relationships>"},
      {"3D/face.model", xml}};
  parts.insert(parts.end(), others.begin(), others.end());
  return zipOf(parts);
}

Mesh readBytes(const std::string& bytes) {
  const TempFolder folder;
  return readMesh(folder.write("a.3mf", bytes));
}

Box boxOf(const std::string& xml, const std::vector<std::pair<std::string, std::string>>& others = {}) {
  return boundingBox(readBytes(file(xml, others)).positions);
}

TEST(ReadThreeMf, EveryUnitIsMillimetres) {
  for (const auto& [unit, scale] : {std::pair<const char*, float>{"micron", 0.001f},
                                    {"millimeter", 1},
                                    {"centimeter", 10},
                                    {"inch", 25.4f},
                                    {"foot", 304.8f},
                                    {"meter", 1000}}) {
    const Box box = boxOf(model(object("1"), "<item objectid=\"1\"/>", "unit=\"" + std::string(unit) + "\""));
    EXPECT_FLOAT_EQ(box.max.x, 10 * scale) << unit;
    EXPECT_FLOAT_EQ(box.max.z, 10 * scale) << unit;
  }
  EXPECT_FLOAT_EQ(boxOf(model(object("1"), "<item objectid=\"1\"/>")).max.x, 10);
  expectError([] { boxOf(model(object("1"), "<item objectid=\"1\"/>", "unit=\"furlong\"")); },
              "has a unit that is none");
}

TEST(ReadThreeMf, ItemsAndComponentsStandWhereTheirTransformsPutThem) {
  // Twice as large, then 100 along x; a component inside is turned by a quarter about z and moved by 5 along y first.
  const std::string objects = object("1") +
                              "<object id=\"2\" type=\"model\"><components><component objectid=\"1\" "
                              "transform=\"0 1 0 -1 0 0 0 0 1 0 5 0\"/></components></object>";
  const Box box = boxOf(model(objects, "<item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 100 0 0\"/>",
                              "unit=\"centimeter\""));
  EXPECT_EQ(box.min, glm::vec3(800, 100, 0));
  EXPECT_EQ(box.max, glm::vec3(1000, 300, 200));
  const Mesh two = readBytes(file(model(
      object("1"), "<item objectid=\"1\"/><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 50 0 0\"/>")));
  EXPECT_EQ(two.triangles.size(), 8u);
  EXPECT_EQ(boundingBox(two.positions).max.x, 60);
}

TEST(ReadThreeMf, AnyNumberOfItems) {
  std::string items;
  for (int i = 0; i < 5000; ++i)
    items += "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 " + std::to_string(20 * i) + " 0 0\"/>";
  const Mesh mesh = readBytes(file(model(object("1"), items)));
  EXPECT_EQ(mesh.triangles.size(), 20'000u);
  EXPECT_EQ(boundingBox(mesh.positions).max.x, 20 * 4999 + 10);
}

TEST(ReadThreeMf, AMirroredItemStaysTurnedOutward) {
  const Mesh mesh =
      readBytes(file(model(object("1"), "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>")));
  EXPECT_EQ(boundingBox(mesh.positions).min.x, -10);
  EXPECT_NEAR(enclosedVolume(mesh), 1000.0 / 6, 1e-3);
}

TEST(ReadThreeMf, ObjectsInOtherParts) {
  const std::string root = model(
      "<object id=\"9\"><components><component p:path=\"/3D/Objects/one.model\" "
      "objectid=\"4\"/></components></object>",
      "<item objectid=\"9\"/>", "requiredextensions=\"p\"");
  const std::string other = model(object("4"), "");
  EXPECT_EQ(boxOf(root, {{"3D/Objects/one.model", other}}).max, glm::vec3(10));
  expectError([&] { boxOf(root); }, "no part where it says");
  expectError(
      [&] {
        boxOf(root, {{"3D/Objects/one.model", model(object("4"), "", "unit=\"inch\"")}});
      },
      "parts in different units");
}

TEST(ReadThreeMf, SupportsAreLeftOutAndSaidSo) {
  const std::string xml =
      model(object("1") + object("2", "type=\"support\""),
            "<item objectid=\"1\"/><item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 50 0 0\"/>");
  std::vector<std::string> said = warningsOf([&] { EXPECT_EQ(boxOf(xml).max.x, 10); });
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("supports"), std::string::npos);
}

TEST(ReadThreeMf, SaysWhatIsWrong) {
  const auto read = [](const std::string& xml) { boxOf(xml); };
  const std::string item = "<item objectid=\"1\"/>";
  expectError([&] { read(model(object("1"), "")); }, "to be built");
  expectError([&] { read(model(object("1"), "<item objectid=\"7\"/>")); }, "does not hold");
  expectError(
      [&] {
        read(model("<object id=\"1\"><components><component objectid=\"1\"/></components></object>", item));
      },
      "without end");
  expectError([&] { read(model(object("1"), "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0\"/>")); },
              "twelve numbers");
  expectError(
      [&] { read(model(object("1"), "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 0 0 0 0\"/>")); },
      "flattens");
  const std::string beams =
      "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" requiredextensions=\"b\"";
  expectError([&] { read(model(object("1"), item, beams)); }, "beam lattices");
  std::string doubled;  // each object is two of the next one
  for (int id = 1; id < 25; ++id) {
    const std::string part = "<component objectid=\"" + std::to_string(id + 1) + "\"/>";
    doubled +=
        "<object id=\"" + std::to_string(id) + "\"><components>" + part + part + "</components></object>";
  }
  expectError([&] { read(model(doubled + "<object id=\"25\"/>", item)); }, "into one another");
  expectError(
      [&] { read(model(object("1"), item, "xmlns:q=\"urn:Featherstone\" requiredextensions=\"q\"")); },
      "not known here");
  expectError([&] { read(model(object("1"), item).substr(0, 300)); }, "not whole XML");
  expectError([&] { read("<!DOCTYPE model [<!ENTITY a \"b\">]>" + model(object("1"), item).substr(22)); },
              "not whole XML");
  const std::string good = file(model(object("1"), item));
  expectError([&] { readBytes(good.substr(0, good.size() - 30)); }, "no whole ZIP file");
  std::string damaged = good;
  damaged[damaged.find("x=\"10\"") + 3] = '9';
  expectError([&] { readBytes(damaged); }, "damaged");
}

}  // namespace
}  // namespace sonoskin
