// Sweeps as PLUS and Slicer write them: reconstructed where the header says where each picture lies, else refused.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/log.h"
#include "core/io/read_options.h"
#include "core/io/stored_volume.h"
#include "core/io/volume_loader.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::expectError;
using test::TempFolder;

constexpr int kWide = 16, kHigh = 12, kFrames = 10;

std::string rows(const glm::dmat4& m) {
  std::string text;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) text += fmt::format(" {}", m[c][r]);
  return text;
}

glm::dmat4 turned(double angle, const glm::dvec3& offset) {
  const double c = std::cos(angle), s = std::sin(angle);
  glm::dmat4 m(1);
  m[0] = {c, s, 0, 0}, m[1] = {-s, c, 0, 0}, m[3] = glm::dvec4(offset, 1);
  return m;
}

// A calibration of 0.5 mm pixels; the probe moves along its normal by 0.5 mm from picture to picture, in the frame of a
// reference that is itself seen by the tracker.
const glm::dmat4 kImageToProbe = [] {
  glm::dmat4 m = turned(0.3, {1, 2, 3});
  m[0] *= 0.5, m[1] *= 0.5;
  return m;
}();
glm::dmat4 probeToReference(int frame) { return turned(-0.7, {10, -5, 0.5 * frame}); }
const glm::dmat4 kReferenceToTracker = turned(1.1, {100, 200, 300});

// A value of its own for each place in the frame of the reference: so what is asked is whether voxels lie where they should.
double valueAt(const glm::dvec3& world) { return 120 + 4 * world.x - 5 * world.y + 3 * world.z; }

std::string pixels(bool flipped) {
  std::string bytes;
  for (int f = 0; f < kFrames; ++f)
    for (int j = 0; j < kHigh; ++j)
      for (int i = 0; i < kWide; ++i) {
        const glm::dvec4 pixel(flipped ? kWide - 1 - i : i, flipped ? kHigh - 1 - j : j, 0, 1);
        bytes += char(std::lround(valueAt(glm::dvec3(probeToReference(f) * kImageToProbe * pixel))));
      }
  return bytes;
}

using Lines = std::vector<std::pair<std::string, std::string>>;

Lines trackedBy(bool calibrated) {
  Lines lines;
  if (calibrated) lines.emplace_back("ImageToProbeTransform", rows(kImageToProbe));
  for (int f = 0; f < kFrames; ++f) {
    const std::string frame = fmt::format("Seq_Frame{:04}_", f);
    lines.emplace_back(frame + "ProbeToTrackerTransform", rows(kReferenceToTracker * probeToReference(f)));
    lines.emplace_back(frame + "ProbeToTrackerTransformStatus", "OK");
    lines.emplace_back(frame + "ReferenceToTrackerTransform", rows(kReferenceToTracker));
    lines.emplace_back(frame + "ImageStatus", "OK");
  }
  return lines;
}

std::string mha(const Lines& lines, const std::string& orientation, const std::string& data) {
  std::string text = "ObjectType = Image\nNDims = 3\nKinds = domain domain list\nElementSpacing = 1 1 1\n";
  if (!orientation.empty()) text += "UltrasoundImageOrientation = " + orientation + "\n";
  for (const auto& [key, value] : lines) text += key + " = " + value + "\n";
  return text +
         fmt::format("DimSize = {} {} {}\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n", kWide, kHigh,
                     kFrames) +
         data;
}

std::string nrrd(const Lines& lines, const std::string& data) {
  std::string text = fmt::format(
      "NRRD0004\ntype: uint8\ndimension: 3\nsizes: {} {} {}\nkinds: domain domain list\nencoding: raw\n",
      kWide, kHigh, kFrames);
  text += "UltrasoundImageOrientation:=MF\n";
  for (const auto& [key, value] : lines) text += key + ":=" + value + "\n";
  return text + "\n" + data;
}

void expectInPlace(const LoadedVolume& loaded) {
  const Geometry& g = loaded.stored.geometry;
  std::size_t compared = 0;
  for (int k = 1; k < g.dims.z - 1; ++k)
    for (int j = 2; j < g.dims.y - 2; ++j)
      for (int i = 2; i < g.dims.x - 2; ++i, ++compared)
        ASSERT_NEAR(loaded.numbers[g.index(i, j, k)], valueAt(g.toWorld({i, j, k})), 2.5);
  EXPECT_GT(compared, 400u);
  EXPECT_FALSE(g.mirrors());
  ASSERT_TRUE(loaded.stored.beam.has_value());
  const glm::dvec3 down =
      glm::normalize(glm::dvec3(probeToReference(5) * kImageToProbe * glm::dvec4(0, 1, 0, 0)));
  EXPECT_LT(glm::distance(loaded.stored.beam->axis, down), 1e-9);
}

TEST(TrackedPictures, BecomeAVolumeInTheFrameOfTheReference) {
  const TempFolder folder;
  expectInPlace(
      loadVolume(folder.write("a.igs.mha", mha(trackedBy(true), "MF", pixels(false))), ReadOptions{}));
  expectInPlace(loadVolume(folder.write("a.seq.nrrd", nrrd(trackedBy(true), pixels(false))), ReadOptions{}));
  // The same pictures stored the other way round.
  expectInPlace(
      loadVolume(folder.write("b.igs.mha", mha(trackedBy(true), "UN", pixels(true))), ReadOptions{}));
}

TEST(TrackedPictures, TransformsMayBeGivenAtOnceOrTheOtherWay) {
  const TempFolder folder;
  Lines lines{{"ProbeToImageTransform", rows(glm::inverse(kImageToProbe))}};
  for (int f = 0; f < kFrames; ++f)
    lines.emplace_back(fmt::format("Seq_Frame{:04}_ProbeToReferenceTransform", f), rows(probeToReference(f)));
  expectInPlace(loadVolume(folder.write("a.mha", mha(lines, "MF", pixels(false))), ReadOptions{}));
  lines.clear();
  for (int f = 0; f < kFrames; ++f)
    lines.emplace_back(fmt::format("Seq_Frame{:04}_ImageToReferenceTransform", f),
                       rows(probeToReference(f) * kImageToProbe));
  expectInPlace(loadVolume(folder.write("b.mha", mha(lines, "MF", pixels(false))), ReadOptions{}));
}

TEST(TrackedPictures, ThatTheTrackerLostAreLeftOut) {
  const TempFolder folder;
  Lines lines = trackedBy(true);
  for (auto& [key, value] : lines) {
    if (key == "Seq_Frame0003_ProbeToTrackerTransformStatus") value = "INVALID";
    if (key == "Seq_Frame0003_ProbeToTrackerTransform") value = rows(turned(2, {900, 900, 900}));
  }
  const LogRecord said;
  const LoadedVolume loaded =
      loadVolume(folder.write("a.mha", mha(lines, "MF", pixels(false))), ReadOptions{});
  expectInPlace(loaded);
  const auto warnings = said.sentences(LogLevel::warning);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], "1 of 10 pictures have no valid place and were left out.");
}

TEST(TrackedPictures, WithoutATransformAreRefusedAndToldWhich) {
  const TempFolder folder;
  const auto load = [&](const std::string& name, const std::string& text) {
    return [&folder, name, text] { loadVolume(folder.write(name, text), ReadOptions{}); };
  };
  const std::string data = pixels(false);
  expectError(load("a.mha", mha(trackedBy(false), "MF", data)), "ImageToProbeTransform");
  expectError(load("a.seq.nrrd", nrrd(trackedBy(false), data)), "ImageToProbeTransform");
  expectError(load("a.mha", mha({}, "MF", data)), "without their places");
  Lines other = trackedBy(false);
  other.emplace_back("ImageToNeedleTransform", rows(kImageToProbe));
  expectError(load("a.mha", mha(other, "MF", data)), "ProbeToTrackerTransform");
  Lines damaged = trackedBy(true);
  damaged[5].second = "1 0 0";
  expectError(load("a.mha", mha(damaged, "MF", data)), "sixteen numbers");
  expectError(load("a.mha", mha(trackedBy(true), "XY", data)), "UltrasoundImageOrientation");
}

// Slicer writes pictures as slices of one voxel, with the row first or last.
TEST(TrackedPictures, RowsOfPicturesAreNeverAStackOfSlices) {
  const TempFolder folder;
  const auto load = [&](const std::string& sizes, const std::string& kinds) {
    return [&folder, sizes, kinds] {
      loadVolume(folder.write("a.seq.nrrd", "NRRD0005\ntype: uint8\ndimension: 4\nencoding: raw\nsizes: " +
                                                sizes + "\nkinds: " + kinds + "\n\n" + std::string(480, 'a')),
                 ReadOptions{});
    };
  };
  expectError(load("8 6 1 10", "domain domain domain list"), "without their places");
  expectError(load("10 8 6 1", "list domain domain domain"), "without their places");
  expectError(load("8 6 1 10", "domain domain domain time"), "without their places");
}

// Old files of PLUS say nothing of kinds; their transforms do.
TEST(TrackedPictures, AreKnownByTheirTransformsToo) {
  const TempFolder folder;
  for (const char* kinds : {"", "Kinds = domain domain domain\n"}) {
    std::string text = mha(trackedBy(true), "MF", pixels(false)),
                bare = mha(trackedBy(false), "MF", pixels(false));
    for (std::string* t : {&text, &bare})
      t->replace(t->find("Kinds"), std::string("Kinds = domain domain list\n").size(), kinds);
    expectInPlace(loadVolume(folder.write("a.mha", text), ReadOptions{}));
    expectError([&] { loadVolume(folder.write("b.mha", bare), ReadOptions{}); }, "ImageToProbeTransform");
  }
}

TEST(TrackedPictures, TheMaskIsWhatTheyCovered) {
  const TempFolder folder;
  const LoadedVolume loaded =
      loadVolume(folder.write("a.mha", mha(trackedBy(true), "MF", pixels(false))), ReadOptions{});
  const Geometry& g = loaded.stored.geometry;
  ASSERT_EQ(loaded.mask.size(), g.voxels());
  EXPECT_TRUE(loaded.mask[g.index(g.dims.x / 2, g.dims.y / 2, g.dims.z / 2)]);
  for (std::size_t v = 0; v < loaded.mask.size(); ++v) EXPECT_TRUE(loaded.mask[v] || loaded.numbers[v] == 0);
}

TEST(TrackedPictures, OfARealSweepWithoutCalibrationAreRefused) {
  const fs::path path = fs::path(SONOSKIN_SHARED_DATA) / "us/plus_bone/BoneUltrasound_L14.igs.mha";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not here";
  expectError([&] { loadVolume(path, ReadOptions{}); },
              "21 tracked pictures without the probe's calibration");
}

}  // namespace
}  // namespace sonoskin
