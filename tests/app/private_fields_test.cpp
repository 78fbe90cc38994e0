// Names that stand inside of files, in every field that a format has for them or that a program may put them in: none of
// them comes out, neither in a result nor in what is said of the file.
#include <gtest/gtest.h>

#include <functional>

#include "core/base/error.h"
#include "core/io/mesh_writer.h"
#include "core/io/meshes/zip_file.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/app/cli_support.h"
#include "tests/support/dicom.h"
#include "tests/support/gltf.h"
#include "tests/support/kretz.h"
#include "tests/support/meshes.h"
#include "tests/support/zip.h"

namespace sonoskin::test {
namespace {

namespace fs = std::filesystem;

// What is planted: a name, a place, a date, a number; as they come out in any case of letters.
const std::string kName = "Featherstone^Wilhelmina", kDate = "19870605", kUid = "1.2.826.4711.81515";

void expectNameless(const std::string& text, const std::string& where) {
  std::string lower = text;
  for (char& c : lower) c = char(std::tolower(static_cast<unsigned char>(c)));
  for (const char* planted : {"featherstone", "wilhelmina", "19870605", "4711.81515"})
    EXPECT_EQ(lower.find(planted), std::string::npos)
        << planted << " in " << where << ": " << text.substr(0, 300);
}

// All that a command says; how it ended is returned.
int sayNothing(const std::vector<std::string>& words, const std::string& where) {
  const ProgramResult result = sonoskin(words);
  expectNameless(result.out, where + ", standard output of " + words[0]);
  expectNameless(result.err, where + ", standard error of " + words[0]);
  return result.status;
}

// Every file of a folder; what is packed in a 3MF is looked at too.
void expectNamelessFiles(const fs::path& folder, const std::string& where) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    expectNameless(fileText(entry.path()), where + ", " + name);
    if (entry.path().extension() == ".3mf")
      expectNameless(ZipFile(entry.path()).part("3D/3DModel.model").value_or(""),
                     where + ", model of " + name);
  }
}

struct PrivateFields : testing::Test {
  const TempFolder folder;

  static Scan smallScan() {
    PhantomOptions phantom;
    phantom.dims = {117, 64, 31};
    return makePhantomScan(phantom);
  }
  // A run with all that it can write.
  void runNameless(const fs::path& input, const std::string& where) {
    const fs::path out = folder / "out";
    ASSERT_EQ(sayNothing({"run", input.string(), "--out", out.string(), "--json", "--size", "64x64",
                          "--mesh.resolution", "60", "--export", "ply,stl,glb,obj,3mf,vtp,dcm", "--keep",
                          "scan,classified,thinned,points", "--bake", "colour", "--print.form", "shell"},
                         where),
              0)
        << where;
    expectNamelessFiles(out, where);
  }
};

// ---- volumes

// A sequence of one item, of explicit length. [DICOM PS3.5, 7.5]
void sequence(DicomBytes& to, std::uint16_t group, std::uint16_t element, const std::string& item) {
  const auto word = [](std::size_t v) {
    return std::string{char(v), char(v >> 8), char(v >> 16), char(v >> 24)};
  };
  to.bytes += {char(group), char(group >> 8), char(element), char(element >> 8)};
  to.bytes += "SQ" + std::string(2, '\0') + word(item.size() + 8);
  to.bytes += std::string("\xFE\xFF\x00\xE0", 4) + word(item.size()) + item;
}

// One slice, with names wherever a standard's or a maker's attribute can have one.
std::string namedSlice(const std::vector<std::uint8_t>& pixels, glm::ivec2 dims, int number) {
  const std::string sop = "1.2.840.10008.5.1.4.1.1.3.1", uid = kUid + "." + std::to_string(number);
  DicomBytes meta, data, nested, length;
  meta.text(2, 2, "UI", sop), meta.text(2, 3, "UI", uid), meta.text(2, 0x10, "UI", "1.2.840.10008.1.2.1");
  meta.text(2, 0x12, "UI", kUid), meta.text(2, 0x13, "SH", "FEATHERSTONE"),
      meta.text(2, 0x16, "AE", "FEATHERSTONE");
  nested.text(8, 0x80, "LO", "Featherstone"), nested.text(0x10, 0x10, "PN", kName),
      nested.text(0x40, 0xA123, "PN", kName);
  data.text(8, 5, "CS", "ISO_IR 100"), data.text(8, 0x12, "DA", kDate), data.text(8, 0x16, "UI", sop);
  data.text(8, 0x18, "UI", uid), data.text(8, 0x20, "DA", kDate), data.text(8, 0x21, "DA", kDate);
  data.text(8, 0x50, "SH", "Featherstone"), data.text(8, 0x60, "CS", "US"),
      data.text(8, 0x70, "LO", "Featherstone");
  data.text(8, 0x80, "LO", "Featherstone"), data.text(8, 0x81, "ST", "Wilhelmina"),
      data.text(8, 0x90, "PN", kName);
  data.text(8, 0x1030, "LO", kName), data.text(8, 0x103E, "LO", kName), data.text(8, 0x1050, "PN", kName);
  sequence(data, 8, 0x1140, nested.bytes);
  data.text(9, 0x10, "LO", "FEATHERSTONE PRIVATE"), data.text(9, 0x1001, "LO", kName);
  data.text(0x10, 0x10, "PN", kName), data.text(0x10, 0x20, "LO", kName), data.text(0x10, 0x30, "DA", kDate);
  data.text(0x10, 0x1000, "LO", kName), data.text(0x10, 0x1040, "LO", kName),
      data.text(0x10, 0x4000, "LT", kName);
  data.text(0x18, 0x1000, "LO", kName), data.text(0x18, 0x1030, "LO", kName);
  data.text(0x20, 0xD, "UI", kUid + ".1"), data.text(0x20, 0xE, "UI", kUid + ".2"),
      data.text(0x20, 0x10, "SH", "Featherstone");
  data.text(0x20, 0x13, "IS", std::to_string(number)),
      data.text(0x20, 0x32, "DS", fmt::format("0\\0\\{}", number));
  data.text(0x20, 0x37, "DS", "1\\0\\0\\0\\1\\0"), data.text(0x20, 0x52, "UI", kUid + ".3");
  data.text(0x20, 0x4000, "LT", kName);
  data.number(0x28, 2, "US", 1), data.text(0x28, 4, "CS", "MONOCHROME2");
  data.number(0x28, 0x10, "US", dims.y), data.number(0x28, 0x11, "US", dims.x),
      data.text(0x28, 0x30, "DS", "1\\1");
  data.number(0x28, 0x100, "US", 8), data.number(0x28, 0x101, "US", 8), data.number(0x28, 0x102, "US", 7);
  data.number(0x28, 0x103, "US", 0);
  data.text(0x32, 0x1060, "LO", kName), data.text(0x40, 0x254, "LO", kName);
  data.number(0x6000, 0x10, "US", 8),
      data.number(0x6000, 0x11, "US", 24);  // an overlay with letters as its dots
  data.text(0x6000, 0x22, "LO", kName), data.text(0x6000, 0x40, "CS", "G"),
      data.text(0x6000, 0x50, "SS", std::string("\1\0\1\0", 4));
  data.number(0x6000, 0x100, "US", 1), data.number(0x6000, 0x102, "US", 0);
  data.text(0x6000, 0x1500, "LO", kName), data.element(0x6000, 0x3000, "OW", kName + " ");
  data.element(0x7FE0, 0x10, "OB", std::string(pixels.begin(), pixels.end()));
  length.element(2, 0, "UL", {char(meta.bytes.size() & 255), char(meta.bytes.size() >> 8 & 255), '\0', '\0'});
  return std::string(128, '\0') + "DICM" + length.bytes + meta.bytes + data.bytes;
}

TEST_F(PrivateFields, OfADicomSeries) {
  const Scan scan = smallScan();
  const glm::ivec3 dims = scan.volume->geometry.dims;
  fs::create_directory(folder / "series");
  for (int k = 0; k < dims.z; ++k) {
    std::vector<std::uint8_t> pixels;
    const std::size_t each = std::size_t(dims.x) * std::size_t(dims.y);
    for (std::size_t v = 0; v < each; ++v)
      pixels.push_back(std::uint8_t(255 * scan.volume->data[std::size_t(k) * each + v]));
    folder.write("series/" + std::to_string(k) + ".dcm", namedSlice(pixels, {dims.x, dims.y}, k + 1));
  }
  EXPECT_EQ(sayNothing({"info", (folder / "series").string(), "--json"}, "DICOM"), 0);
  EXPECT_EQ(sayNothing({"info", (folder / "series/3.dcm").string()}, "DICOM"), 0);
  runNameless(folder / "series", "DICOM");
}

TEST_F(PrivateFields, OfNrrd) {
  writeScan(folder / "a.nrrd", smallScan());
  std::string bytes = fileText(folder / "a.nrrd");
  const std::size_t end = bytes.find("\n\n");
  ASSERT_NE(end, std::string::npos);
  bytes.insert(end, "\n# " + kName + "\ncontent: " + kName + "\nPatientName:=" + kName +
                        "\nDICOM_0008_0020:=" + kDate);
  const fs::path file = folder.write("b.nrrd", bytes);
  EXPECT_EQ(sayNothing({"info", file.string()}, "NRRD"), 0);
  runNameless(file, "NRRD");
}

// Patient, hospital, probe, examination and machine have records of their own; what is not known may hold anything. [GE Kretz]
std::string namedKretz(bool asSamples) {
  KretzWriter kretz;
  for (const auto& [group, element] :
       {std::pair{0x0110u, 1u}, {0x0110, 2}, {0x0120, 1}, {0x0130, 1}, {0x0140, 2}, {0x0150, 7}, {0x0900, 1}})
    kretz.record(group, element, kName);
  kretz.record(0x0110, 3, kDate).record(0x0140, 3, kDate).dims(12, 8, 6);
  if (asSamples)
    kretz.torus({1.27, 1.36, 1.45, 1.54, 1.62, 1.71, 1.80, 1.89}, {1.36, 1.45, 1.54, 1.62, 1.71, 1.80});
  else
    kretz.values(0x0010, 0x22, {0.5});
  return kretz.record(0xD000, 1, ramp(12 * 8 * 6)).record(0x0900, 2, kName).end().bytes();
}

TEST_F(PrivateFields, OfKretz) {
  for (const bool asSamples : {false, true}) {
    const std::string file = folder.write("a.vol", namedKretz(asSamples)).string();
    EXPECT_EQ(sayNothing({"info", file, "--json"}, "Kretz"), 0);
    EXPECT_EQ(sayNothing({"info", file}, "Kretz"), 0);
    EXPECT_EQ(
        sayNothing({"info",
                    folder.write("b.vol", namedKretz(asSamples).substr(0, namedKretz(asSamples).size() - 100))
                        .string()},
                   "cut Kretz"),
        3);
  }
}

// What is read is described without a name, and where it is refused nothing is quoted that could be one.
TEST_F(PrivateFields, OfOtherVolumes) {
  Volume<std::uint8_t> box(Geometry{.dims = {8, 7, 6}});
  for (std::size_t v = 0; v < box.data.size(); ++v) box.data[v] = std::uint8_t(v % 250);
  writeVolume(folder / "a.mha", box);
  writeVolume(folder / "a.vtk", box);
  std::string meta = fileText(folder / "a.mha"), vtk = fileText(folder / "a.vtk");
  meta.insert(meta.find("DimSize"), "Comment = " + kName + "\nName = " + kName + "\n");
  const std::size_t title = vtk.find('\n') + 1;
  vtk.replace(title, vtk.find('\n', title) - title, kName + " " + kDate);
  std::string nifti(352, '\0');
  const auto put = [&](std::size_t at, const std::string& text) { nifti.replace(at, text.size(), text); };
  const auto number = [](auto value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(0, number(std::int32_t(348))), put(14, "Wilhelmina");
  const std::int16_t dim[] = {3, 8, 7, 6, 1, 1, 1, 1};
  for (std::size_t d = 0; d < 8; ++d) put(40 + 2 * d, number(dim[d])), put(76 + 4 * d, number(1.f));
  put(70, number(std::int16_t(2))), put(72, number(std::int16_t(8))), put(108, number(352.f));
  put(148, kName + " " + kDate), put(228, kName), put(254, number(std::int16_t(1))), put(328, "Wilhelmina");
  for (int r = 0; r < 3; ++r) put(std::size_t(280 + 20 * r), number(1.f));
  put(344, std::string("n+1\0", 4));
  nifti.append(box.data.begin(), box.data.end());
  for (const auto& [name, bytes] :
       {std::pair<std::string, std::string>{"b.mha", meta}, {"b.vtk", vtk}, {"b.nii", nifti}}) {
    const std::string file = folder.write(name, bytes).string();
    EXPECT_EQ(sayNothing({"info", file}, name), 0);
    EXPECT_EQ(sayNothing({"info", file, "--json"}, name), 0);
  }
}

// ---- meshes

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

// Meshes with names in their comments, titles and parts.
std::vector<std::pair<std::string, std::string>> namedMeshes(const TempFolder& folder) {
  const Mesh ball = icosphere(2, 40, {});
  const auto written = [&](const char* name) {
    writeMesh(folder / name, ball);
    return fileText(folder / name);
  };
  const std::string obj = written("p.obj");
  std::string stl = written("p.stl"), text = "solid " + kName + " " + kDate + "\n";
  stl.replace(0, 40, (kName + std::string(40, ' ')).substr(0, 40));
  for (const Triangle& t : ball.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : t)
      text += fmt::format("vertex {} {} {}\n", ball.positions[v].x, ball.positions[v].y, ball.positions[v].z);
    text += "endloop\nendfacet\n";
  }
  GltfMaker glb;
  std::vector<float> places;
  std::vector<std::uint16_t> corners;
  for (const glm::vec3& p : ball.positions)
    places.insert(places.end(), {0.001f * p.x, 0.001f * p.y, 0.001f * p.z});
  for (const Triangle& t : ball.triangles)
    for (const std::uint32_t v : t) corners.push_back(std::uint16_t(v));
  glb.primitive()["attributes"]["POSITION"] = glb.floats(places, "VEC3", 3);
  glb.primitive()["indices"] = glb.indices(corners);
  glb.root["asset"].update({{"copyright", kName}, {"generator", kName}, {"extras", {{"patient", kName}}}});
  glb.node()["name"] = glb.root["meshes"][0]["name"] = glb.root["scenes"][0]["name"] = kName;
  glb.node()["extras"] = {{kName, kDate}};
  const std::string model =
      ZipFile((written("p.3mf"), folder / "p.3mf")).part("3D/3DModel.model").value_or("");
  return {
      {"a.ply",
       replaced(written("p.ply"), "\nelement", "\ncomment " + kName + "\nobj_info " + kDate + "\nelement")},
      {"a.obj", "# " + kName + "\no " + kName + "\ng " + kName + "\nmtllib " + kName + ".mtl\nusemtl " +
                    kName + "\n" + obj},
      {"a.stl", stl},
      {"b.stl", text + "endsolid " + kName + "\n"},
      {"a.glb", glb.glb()},
      {"a.3mf",
       zipOf({{"3D/3dmodel.model", replaced(model, "<resources>",
                                            "<metadata name=\"Title\">" + kName + "</metadata><resources>")},
              {"Metadata/" + kName + ".txt", kName}})},
      {"a.vtp", replaced(written("p.vtp"), "<FieldData>",
                         "<!-- " + kName +
                             " --><FieldData><Array type=\"String\" Name=\"Wilhelmina\" "
                             "format=\"ascii\">70 101 97 0</Array>")}};
}

TEST_F(PrivateFields, OfMeshes) {
  for (const auto& [name, bytes] : namedMeshes(folder)) {
    SCOPED_TRACE(name);
    const std::string file = folder.write(name, bytes).string(), out = (folder / "out.png").string(),
                      glb = (folder / "out.glb").string();
    EXPECT_EQ(sayNothing({"info", file, "--json"}, name), 0);
    EXPECT_EQ(sayNothing({"info", file}, name), 0);
    EXPECT_EQ(sayNothing({"compare", file, file, "--json"}, name), 0);
    EXPECT_EQ(
        sayNothing({"render", file, "--out", out, "--size", "64x64", "--quality", "light", "--json"}, name),
        0);
    expectNameless(fileText(out), "the picture");
    EXPECT_EQ(
        sayNothing({"render", file, "--out", glb, "--bake", "colour", "--quality", "light", "--json"}, name),
        0);
    expectNameless(fileText(glb), "the surface with skin");
  }
}

// Where a file is refused, nothing of it is quoted that could be a name.
TEST_F(PrivateFields, OfMeshesThatAreRefused) {
  const std::vector<std::pair<std::string, std::string>> broken{
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf " + kName + " 2 3\n"},
      {"b.obj", "v Featherstone 0 0\n"},
      {"a.ply", "ply\nformat ascii 1.0\nelement " + kName + " many\nend_header\n"},
      {"b.ply", "ply\nformat " + kName + " 1.0\nend_header\n"},
      {"a.stl", "solid a\nfacet " + kName + "\n" + kName + "\n"},
      {"a.3mf", zipOf({{"3D/3dmodel.model", "<model unit=\"" + kName + "\"/>"}})},
      {"b.3mf",
       zipOf({{"3D/3dmodel.model", "<model xmlns:f=\"urn:" + kName + "\" requiredextensions=\"f\"/>"}})},
      {"a.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"extensionsRequired\": [\"KHR_Featherstone\"]}"},
      {"b.gltf",
       "{\"asset\": {\"version\": \"2.0\"}, \"buffers\": [{\"byteLength\": 4, \"uri\": "
       "\"Featherstone.bin\"}]}"},
      {"c.gltf", "{\"Wilhelmina\" Featherstone}"},
      {"a.vtp", "<VTKFile type=\"" + kName + "\"/>"},
      {"b.vtp", "<Featherstone>"}};
  for (const auto& [name, bytes] : broken)
    EXPECT_EQ(sayNothing({"info", folder.write(name, bytes).string()}, name), 3) << name;
}

}  // namespace
}  // namespace sonoskin::test
