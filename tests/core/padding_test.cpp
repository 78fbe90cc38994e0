#include "core/io/padding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/io/normalise.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// A recorded ball of noise, 20 to 200, in what `outside` gives.
template <class Outside>
Volume<float> ballIn(const Outside& outside) {
  std::uint64_t n = 0;
  return test::fill(test::grid({24, 24, 24}), [&](glm::dvec3 p) {
    const double noise = test::noise(n++);
    return glm::length(p - 11.5) < 11 ? 20 + 180 * noise : outside(noise);
  });
}

NormalisedVolume normalised(const Volume<float>& volume) {
  StoredVolume stored;
  stored.geometry = volume.geometry;
  stored.type = NumberType::float32;
  std::vector<std::uint8_t> numbers(volume.data.size() * sizeof(float));
  std::memcpy(numbers.data(), volume.data.data(), numbers.size());
  return normalise(stored, numbers);
}

// The same scan in any padding is the same scan: 0 outside, and inside as it was.
TEST(Padding, WhateverItsValueItIsOutside) {
  const Volume<float> zero = normalised(ballIn([](double) { return 0.0; })).volume;
  const double far = -double(std::numeric_limits<float>::max());
  for (const double value : {-1.0, -1024.0, -2000.0, 255.0, 70.0, far}) {
    const Volume<float> other = normalised(ballIn([&](double) { return value; })).volume;
    for (std::size_t v = 0; v < zero.data.size(); ++v)
      ASSERT_NEAR(other.data[v], zero.data[v], 1e-6) << value;
  }
  const Volume<float> nearly = normalised(ballIn([](double noise) { return std::floor(4 * noise); })).volume;
  for (std::size_t v = 0; v < zero.data.size(); ++v) ASSERT_NEAR(nearly.data[v], zero.data[v], 1e-6);
}

TEST(Padding, IsNotWhatWasRecordedUpToTheSides) {
  std::uint64_t n = 0;
  const auto noise =
      test::fill(test::grid({20, 20, 20}), [&](glm::dvec3) { return 100 + 50 * test::noise(n++); });
  EXPECT_FALSE(findPadding(noise));
  EXPECT_FALSE(findPadding(Volume<float>(test::grid({8, 8, 8}), 7)));  // constant: there is nothing else
}

// A recording whose sides are padded as to a share, with values from 0 to `spread`.
Volume<float> paddedSides(double share, double spread) {
  std::uint64_t n = 0;
  return test::fill(test::grid({30, 30, 30}), [&](glm::dvec3 p) {
    const double chance = test::noise(n++), recorded = 20 + 180 * test::noise(n++), value = test::noise(n++);
    const bool onSide = std::min({p.x, p.y, p.z}) == 0 || std::max({p.x, p.y, p.z}) == 29;
    return onSide && chance < share ? spread * value : recorded;
  });
}

TEST(Padding, IsMostOfTheSides) {
  const auto found = findPadding(paddedSides(0.56, 0));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->least, 0);
  EXPECT_EQ(found->most, 0);
  EXPECT_FALSE(findPadding(paddedSides(0.45, 0)));
}

// A plate of which the two large sides are padded, or one of them: too little.
TEST(Padding, AllSixSidesCount) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 dims(20);
    dims[axis] = 6;
    const auto plate = [&](bool first, bool last) {
      std::uint64_t n = 0;
      return test::fill(test::grid(dims), [&](glm::dvec3 p) {
        const double recorded = 20 + 180 * test::noise(n++);
        return (first && p[axis] == 0) || (last && p[axis] == 5) ? -1 : recorded;
      });
    };
    EXPECT_TRUE(findPadding(plate(true, true))) << axis;
    EXPECT_FALSE(findPadding(plate(true, false))) << axis;
    EXPECT_FALSE(findPadding(plate(false, true))) << axis;
  }
  Volume<float> half(test::grid({2, 2, 2}), 0);
  for (std::size_t v = 0; v < 4; ++v) half.data[v] = 50.f + 10 * float(v);
  EXPECT_FALSE(findPadding(half)) << "half of the sides is not most of them";
}

// 2 % of what is recorded, from which a single voxel does not lead away.
TEST(Padding, MayBeNearlyAlike) {
  for (const float brightest : {200.f, 1e4f, -1e4f}) {
    Volume<float> narrow = paddedSides(0.9, 3), wide = paddedSides(0.9, 8);
    narrow.at(9, 9, 9) = wide.at(9, 9, 9) = brightest;
    const auto found = findPadding(narrow);
    ASSERT_TRUE(found);
    EXPECT_GE(found->least, 0);
    EXPECT_LT(found->least, 0.1f);
    EXPECT_GT(found->most, 2.9f);
    EXPECT_LE(found->most, 3);
    EXPECT_FALSE(findPadding(wide)) << brightest;
  }
}

TEST(Normalise, DoesNotDependOnTheType) {
  const auto scan = ballIn([](double) { return 0.0; });
  const Volume<float> whole = normalised(scan).volume;
  for (const float factor : {1 / 255.f, 257.f}) {
    Volume<float> other = scan;
    for (float& v : other.data) v *= factor;
    const Volume<float> same = normalised(other).volume;
    for (std::size_t v = 0; v < whole.data.size(); ++v) ASSERT_NEAR(same.data[v], whole.data[v], 1e-6);
  }
  for (std::size_t v = 0; v < whole.data.size(); ++v) ASSERT_NEAR(whole.data[v], scan.data[v] / 255, 1e-6);
}

TEST(Normalise, ConstantVolumesOfAnySizeAreFinite) {
  for (const float value : {0.f, 1e16f, -3.4e38f, 2e18f})
    for (const float v : normalised(Volume<float>(test::grid({4, 4, 4}), value)).volume.data) ASSERT_EQ(v, 0);
}

// One number among millions that are none, where samples of a large volume do not look.
TEST(Padding, OfHardlyAnyNumbersIsNone) {
  Volume<float> empty(test::grid({130, 130, 100}), std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(findPadding(empty));
  empty.data[1] = 0.5f;
  EXPECT_FALSE(findPadding(empty));
}

// Where numbers that are none mark the outside, the few others on the sides are no padding: their value is recorded too.
TEST(Padding, IsNotWhatLittleLiesOnSidesThatAreNone) {
  Volume<float> volume = ballIn([](double) { return double(std::numeric_limits<float>::quiet_NaN()); });
  volume.at(12, 12, 0) = volume.at(12, 11, 0) = 100;
  volume.at(12, 12, 12) = 100;
  EXPECT_FALSE(findPadding(volume));
  EXPECT_GT(normalised(volume).volume.at(12, 12, 12), 0);
}

// A mask may mark all of a volume's sides; that is no padding.
TEST(Padding, IsNotLookedForInMarks) {
  Volume<float> mask(test::grid({10, 10, 10}), 1);
  mask.at(5, 5, 5) = 0;
  StoredVolume stored;
  stored.geometry = mask.geometry;
  stored.type = NumberType::float32;
  std::vector<std::uint8_t> numbers(mask.data.size() * sizeof(float));
  std::memcpy(numbers.data(), mask.data.data(), numbers.size());
  EXPECT_EQ(normalise(stored, numbers, {}, false).volume.at(0, 0, 0), 1);
  EXPECT_EQ(normalise(stored, numbers, {}, false).volume.at(5, 5, 5), 0);
}

}  // namespace
}  // namespace sonoskin
