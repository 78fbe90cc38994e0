// The classification does not depend on how a scan is stored: its number type, its unit of length.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "core/classification/classify.h"
#include "core/io/volume_reader.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

constexpr Formulation kAll[] = {Formulation::variational, Formulation::thesisClosed, Formulation::thesisSkew};

// A noisy ball as grey values 0..255; both ends occur often, as they do in scans.
Volume<float> greys() {
  auto v = test::speckledSphere(test::grid({16, 15, 14}, {0.3, 0.3, 0.9}), {2.2, 2.2, 6}, 1.5, 0.3);
  for (float& value : v.data) value = std::round(255 * std::clamp(1.4f * (value - 0.1f), 0.0f, 1.0f));
  return v;
}

// A raw NRRD file of `greys * factor + offset` as numbers of type T.
template <class T>
std::string nrrdOf(const Volume<float>& v, const std::string& type, double factor, double offset) {
  const glm::ivec3 d = v.geometry.dims;
  const glm::dvec3 s = v.geometry.spacing;
  std::string text = "NRRD0004\ntype: " + type + "\ndimension: 3\nsizes: " + std::to_string(d.x) + " " +
                     std::to_string(d.y) + " " + std::to_string(d.z) + "\nspacings: " + std::to_string(s.x) +
                     " " + std::to_string(s.y) + " " + std::to_string(s.z) +
                     "\nendian: little\nencoding: raw\n\n";
  for (const float grey : v.data) {
    const T number = T(factor * double(grey) + offset);
    text.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  return text;
}

LargeArray<float> classified(const Volume<float>& volume, Formulation formulation) {
  ClassificationOptions o;
  o.formulation = formulation;
  o.isoValue = 0.4;
  o.tolerance = 1e-4;
  return classify(volume, smooth(volume, o), o).data;
}

void expectSame(const LargeArray<float>& a, const LargeArray<float>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], tolerance) << i;
}

TEST(ClassificationScale, IsTheSameForEveryNumberType) {
  const test::TempFolder folder;
  const Volume<float> v = greys();
  const auto read = [&](const std::string& name, const std::string& text) {
    return *readScan(folder.write(name, text)).volume;
  };
  const Volume<float> bytes = read("bytes.nrrd", nrrdOf<std::uint8_t>(v, "uint8", 1, 0));
  const Volume<float> others[] = {read("wide.nrrd", nrrdOf<std::uint16_t>(v, "uint16", 257, 0)),
                                  read("narrow.nrrd", nrrdOf<std::uint16_t>(v, "uint16", 1, 0)),
                                  read("signed.nrrd", nrrdOf<std::int16_t>(v, "int16", 12, -1500)),
                                  read("float.nrrd", nrrdOf<float>(v, "float", 0.37, 1))};
  for (const Formulation f : kAll) {
    const auto expected = classified(bytes, f);
    for (const Volume<float>& other : others) expectSame(classified(other, f), expected, 1e-3);
  }
}

TEST(ClassificationScale, IsTheSameInEveryUnitOfLength) {
  Volume<float> v = greys();
  for (float& value : v.data) value /= 255;
  Volume<float> metres = v;
  metres.geometry.spacing /= 1000.0;
  for (const Formulation f : kAll) expectSame(classified(metres, f), classified(v, f), 1e-3);
}

}  // namespace
}  // namespace sonoskin
