#include "core/volume/mask_depth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/volume/field_of_view.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

const glm::ivec3 kDims(11, 9, 7);
const glm::dvec3 kSpacing(0.5, 0.7, 1.1);

Volume<std::uint8_t> ballMask() {
  Volume<std::uint8_t> mask(test::grid(kDims, kSpacing));
  for (int k = 0; k < kDims.z; ++k)
    for (int j = 0; j < kDims.y; ++j)
      for (int i = 0; i < kDims.x; ++i)
        mask.at(i, j, k) = glm::distance(glm::dvec3(i, j, k) * kSpacing, {2, 3, 3.5}) < 2.6 ? 200 : 0;
  return mask;
}

// The nearest voxel outside, beyond the volume too, by asking all of them.
double bruteForceDistance(const Volume<std::uint8_t>& mask, const glm::ivec3& v) {
  double nearest = 1e9;
  for (int k = -1; k <= kDims.z; ++k)
    for (int j = -1; j <= kDims.y; ++j)
      for (int i = -1; i <= kDims.x; ++i) {
        const bool within = i >= 0 && j >= 0 && k >= 0 && i < kDims.x && j < kDims.y && k < kDims.z;
        if (within && mask.at(i, j, k)) continue;
        nearest = std::min(nearest, glm::length(glm::dvec3(glm::ivec3(i, j, k) - v) * kSpacing));
      }
  return nearest;
}

TEST(MaskDepth, AgreesWithBruteForce) {
  const auto mask = ballMask();
  const auto depth = maskDepth(mask);
  for (int k = 0; k < kDims.z; ++k)
    for (int j = 0; j < kDims.y; ++j)
      for (int i = 0; i < kDims.x; ++i) {
        const float found = depthInMask(depth, glm::vec3(i, j, k) * glm::vec3(kSpacing));
        if (mask.at(i, j, k))
          EXPECT_NEAR(double(found), bruteForceDistance(mask, {i, j, k}) - 0.25,
                      0.5 / 8);  // half a voxel; a step
        else
          EXPECT_LT(found, 0);
      }
}

TEST(MaskDepth, OfAFullMaskIsTheDistanceFromTheBox) {
  Volume<std::uint8_t> full(test::grid({100, 90, 80}), 1);
  const auto depth = maskDepth(full);
  EXPECT_NEAR(depthInMask(depth, {4, 40, 40}), 4.5, 0.13);
  EXPECT_GT(depthInMask(depth, {50, 45, 40}), 1e6f);  // farther in than a byte can tell
  EXPECT_LT(depthInMask(depth, {-3, 40, 40}), 0);
}

TEST(MaskDepth, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(maskDepth(ballMask(), Progress(sink)), Cancelled);
}

Scan scanOf(const Volume<float>& volume) {
  Scan scan;
  scan.volume = std::make_shared<const Volume<float>>(volume);
  scan.key = scanKey(volume, {});
  return scan;
}

TEST(Mask, IsTheViewAndItsSectorTellsTheBeams) {
  Scan scan = scanOf(Volume<float>(test::grid({60, 50, 60}), 0.3f));  // nothing is padded
  const auto mask = test::fill(scan.volume->geometry, [](glm::dvec3 p) {
    const double half = (p.y + 20) * std::tan(0.4);
    return std::abs(p.x - 29.5) < half && std::abs(p.z - 29.5) < half ? 1.0 : 0.0;
  });
  const Key unmasked = scan.key;
  setMask(scan, scanOf(mask));
  EXPECT_FALSE(scan.key == unmasked);
  const FieldOfView view = findFieldOfView(scan, {});
  EXPECT_LT(view.depth({5, 10, 30}), 0);
  EXPECT_NEAR(view.depth({29, 5, 30}), 5.5, 0.6);  // from the volume's own face
  ASSERT_TRUE(view.origin.has_value());
  EXPECT_LT(glm::distance(*view.origin, glm::vec3(29.5f, -20, 29.5f)), 2.5f);
}

TEST(Mask, ZeroIsWhatWasZeroInTheFile) {
  Scan scan = scanOf(Volume<float>(test::grid({4, 4, 4}), 0.3f));
  Scan mask = scanOf(Volume<float>(test::grid({4, 4, 4}), float(128.0 / 255)));  // zeros of an int8 file
  mask.originalMin = -128;
  mask.originalMax = 127;
  auto changed = std::make_shared<Volume<float>>(*mask.volume);
  changed->at(1, 2, 3) = float(129.0 / 255);
  mask.volume = changed;
  setMask(scan, mask);
  int count = 0;
  for (const auto m : scan.mask->data) count += m != 0;
  EXPECT_EQ(count, 1);
  EXPECT_EQ(scan.mask->at(1, 2, 3), 1);
}

// A mask lies where its header says: with axes turned over it marks the same places, elsewhere it marks none.
TEST(Mask, IsLookedUpInTheWorld) {
  Scan scan = scanOf(Volume<float>(test::grid({8, 9, 10}, {0.5, 0.6, 0.7}), 0.3f));
  const auto marks =
      test::fill(scan.volume->geometry, [](glm::dvec3 p) { return p.x < 1.2 && p.z > 3 ? 1.0 : 0.0; });
  setMask(scan, scanOf(marks));
  const auto expected = scan.mask->data;
  Volume<float> flipped = marks;
  Geometry& g = flipped.geometry;
  g.origin = marks.geometry.toWorld({7, 0, 0});
  g.direction[0] = -g.direction[0];
  for (int k = 0; k < 10; ++k)
    for (int j = 0; j < 9; ++j)
      for (int i = 0; i < 8; ++i) flipped.at(i, j, k) = marks.at(7 - i, j, k);
  setMask(scan, scanOf(flipped));
  EXPECT_EQ(scan.mask->data, expected);
  Volume<float> far = marks;
  far.geometry.origin += glm::dvec3(500, 0, 0);
  EXPECT_THROW(setMask(scan, scanOf(far)), Error);
  EXPECT_THROW(setErased(scan, scanOf(far)), Error);
  Scan without = scanOf(far);  // a file that does not say where it lies: voxel by voxel
  without.spacingKnown = false;
  setMask(scan, without);
  EXPECT_EQ(scan.mask->data, expected);
}

TEST(Mask, ElsewhereOrOfNothingIsRefused) {
  Scan scan = scanOf(Volume<float>(test::grid({4, 5, 6}), 0.3f));
  const auto complaint = [&](const Volume<float>& mask) -> std::string {
    try {
      setMask(scan, scanOf(mask));
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(complaint(Volume<float>(test::grid({2, 2, 2}), 1)).find("does not lie where"), std::string::npos);
  EXPECT_NE(complaint(Volume<float>(test::grid({4, 5, 6}))).find("zero everywhere"), std::string::npos);
  EXPECT_FALSE(scan.mask);
}

}  // namespace
}  // namespace sonoskin
