// What stands in the files of written volumes, by the words of their formats and without the libraries that wrote them.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <sstream>

#include "core/io/volume_writer.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::fileText;
using test::TempFolder;

// Frame: where a file says that voxels lie, in LPS mm: columns are one voxel's steps along i, j and k.
struct Frame {
  glm::ivec3 dims{0};
  glm::dmat3 steps{0};
  glm::dvec3 origin{0};
};

// The numbers of a text, whatever stands between them.
std::vector<double> numbersIn(std::string text) {
  for (char& c : text)
    if (std::strchr("0123456789+-.e", c) == nullptr) c = ' ';
  std::istringstream stream(text);
  std::vector<double> values;
  for (double v = 0; stream >> v;) values.push_back(v);
  return values;
}

// The rest of the line that begins with a key.
std::string lineOf(const std::string& head, const std::string& key) {
  const std::size_t at = ("\n" + head).find("\n" + key);
  EXPECT_NE(at, std::string::npos) << key;
  return at == std::string::npos ? "" : head.substr(at + key.size(), head.find('\n', at) - at - key.size());
}

std::string inflated(const std::string& packed) {
  std::string bytes(1u << 20, '\0');
  z_stream stream{};
  inflateInit2(&stream, 15 + 32);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = uInt(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = uInt(bytes.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  bytes.resize(stream.total_out);
  inflateEnd(&stream);
  return bytes;
}

Frame frameOf(const std::vector<double>& dims, const std::vector<double>& steps,
              const std::vector<double>& origin) {
  Frame frame;
  for (int i = 0; i < 3; ++i) {
    frame.dims[i] = int(dims.at(std::size_t(i)));
    frame.origin[i] = origin.at(std::size_t(i));
    for (int r = 0; r < 3; ++r) frame.steps[i][r] = steps.at(std::size_t(3 * i + r));
  }
  return frame;
}

// Gives the voxels too, as bytes.
Frame nrrd(const std::string& file, std::string& voxels) {
  const std::string head = file.substr(0, file.find("\n\n") + 1);
  EXPECT_EQ(lineOf(head, "space: "), "left-posterior-superior");
  EXPECT_EQ(lineOf(head, "encoding: "), "gzip");
  voxels = inflated(file.substr(head.size() + 1));
  return frameOf(numbersIn(lineOf(head, "sizes:")), numbersIn(lineOf(head, "space directions:")),
                 numbersIn(lineOf(head, "space origin:")));
}

Frame meta(const std::string& file, std::string& voxels) {
  const std::string end = "ElementDataFile = LOCAL\n", head = file.substr(0, file.find(end));
  voxels = inflated(file.substr(head.size() + end.size()));
  const auto spacing = numbersIn(lineOf(head, "ElementSpacing ="));
  auto steps = numbersIn(lineOf(head, "TransformMatrix ="));
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] *= spacing.at(i / 3);
  return frameOf(numbersIn(lineOf(head, "DimSize =")), steps, numbersIn(lineOf(head, "Offset =")));
}

template <class T>
T at(const std::string& bytes, std::size_t where) {
  T value;
  std::memcpy(&value, bytes.data() + where, sizeof value);
  return value;
}

// NIfTI is RAS. [NIfTI-1, method 3]
Frame nifti(const std::string& file, std::string& voxels) {
  const std::string bytes = inflated(file);
  EXPECT_EQ(at<std::int32_t>(bytes, 0), 348);
  EXPECT_GT(at<std::int16_t>(bytes, 254), 0);  // sform
  EXPECT_EQ(bytes[123] & 7, 2);                // mm
  voxels = bytes.substr(std::size_t(at<float>(bytes, 108)));
  Frame frame;
  for (int i = 0; i < 3; ++i) {
    frame.dims[i] = at<std::int16_t>(bytes, 42 + 2 * std::size_t(i));
    for (int r = 0; r < 3; ++r) {
      const double value = double(at<float>(bytes, 280 + 16 * std::size_t(r) + 4 * std::size_t(i)));
      frame.steps[i][r] = r < 2 ? -value : value;
    }
    const double origin = double(at<float>(bytes, 280 + 16 * std::size_t(i) + 12));
    frame.origin[i] = i < 2 ? -origin : origin;
  }
  return frame;
}

class WrittenVolume : public testing::TestWithParam<const char*> {};

TEST_P(WrittenVolume, LiesWhereItsVoxelsLie) {
  const TempFolder folder;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int round = 0; round < 20; ++round) {
    Volume<std::uint8_t> volume(
        Geometry{.dims = {5, 4, 3},
                 .spacing = {0.3 + 0.2 * std::abs(any(random)), 0.7, 1.25},
                 .origin = {100 * any(random), 100 * any(random), 100 * any(random)}});
    Geometry& g = volume.geometry;
    const glm::dquat q(any(random), any(random), any(random), any(random));
    g.direction = glm::mat3_cast(glm::normalize(q));
    if (round % 2) g.direction[2] = -g.direction[2];  // mirrored
    for (std::size_t v = 0; v < volume.data.size(); ++v) volume.data[v] = std::uint8_t(4 * v + 1);
    const auto path = folder / (std::string("a") + GetParam());
    writeVolume(path, volume);
    std::string voxels;
    const std::string bytes = fileText(path);
    const Frame frame = path.extension() == ".nrrd"  ? nrrd(bytes, voxels)
                        : path.extension() == ".mha" ? meta(bytes, voxels)
                                                     : nifti(bytes, voxels);
    EXPECT_EQ(frame.dims, g.dims);
    EXPECT_EQ(voxels, std::string(volume.data.begin(), volume.data.end()));
    for (int i = 0; i < 3; ++i)
      EXPECT_LT(glm::length(frame.steps[i] - g.direction[i] * g.spacing[i]), 1e-5) << "axis " << i;
    EXPECT_LT(glm::length(frame.origin - g.origin), 1e-5 * 100);
  }
}

INSTANTIATE_TEST_SUITE_P(All, WrittenVolume, testing::Values(".nrrd", ".mha", ".nii.gz"));

}  // namespace
}  // namespace sonoskin
