#include "core/volume/resample.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/volume/sample.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// A linear function has the same value at the same place in the world at any resolution.
TEST(HalveResolution, KeepsTheWorldFrame) {
  Geometry g = test::grid({21, 16, 9}, {0.3, 0.3, 0.9});
  g.origin = {5, -7, 2};
  g.direction = glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
  const auto f = [](glm::dvec3 p) { return 0.1 * p.x - 0.2 * p.y + 0.05 * p.z; };
  const auto half = halveResolution(test::fill(g, f));
  EXPECT_EQ(half.geometry.dims, glm::ivec3(10, 8, 9));  // k is coarse already
  for (int k = 0; k < 9; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 10; ++i) EXPECT_NEAR(half.at(i, j, k), f(half.geometry.toWorld({i, j, k})), 1e-5);
}

TEST(CropVolume, KeepsValuesAndTheirPlacesInTheWorld) {
  Geometry g = test::grid({7, 6, 5}, {0.3, 0.5, 0.9});
  g.origin = {5, -7, 2};
  g.direction = glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
  const auto f = [](glm::dvec3 p) { return 0.1 * p.x - 0.2 * p.y + 0.05 * p.z; };
  const Volume<float> cut = cropVolume(test::fill(g, f), {2, 1, 3}, {4, 5, 2});
  EXPECT_EQ(cut.geometry.dims, glm::ivec3(4, 5, 2));
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 4; ++i) EXPECT_NEAR(cut.at(i, j, k), f(cut.geometry.toWorld({i, j, k})), 1e-5);
}

TEST(CropVolume, RefusesWhatIsNotInside) {
  const Volume<float> volume(test::grid({7, 6, 5}));
  EXPECT_THROW(cropVolume(volume, {0, 0, 0}, {8, 6, 5}), Error);
  EXPECT_THROW(cropVolume(volume, {-1, 0, 0}, {3, 3, 3}), Error);
  EXPECT_THROW(cropVolume(volume, {0, 0, 0}, {3, 0, 3}), Error);
}

TEST(SampleTrilinear, IsExactOnProductsOfLines) {
  const auto volume =
      test::fill(test::grid({6, 5, 4}), [](glm::dvec3 p) { return (1 + p.x) * (2 - p.y) + p.z * p.x; });
  EXPECT_NEAR(sampleTrilinear(volume, {2.25f, 3.5f, 1.75f}), 3.25 * -1.5 + 1.75 * 2.25, 1e-5);
  EXPECT_NEAR(sampleTrilinear(volume, {-3, 9, 3}), 1 * -2.0, 1e-6);  // clamped to (0, 4, 3)
}

TEST(GradientAt, OfALinearFunctionIsItsSlopePerSmallestSpacing) {
  const Geometry g = test::grid({5, 5, 5}, {0.5, 1, 2});
  const auto volume = test::fill(g, [](glm::dvec3 p) { return 3 * p.x + 5 * p.y - 7 * p.z; });
  const glm::vec3 gradient = gradientAt(volume, g.axisScale(), g.index(2, 2, 2));
  EXPECT_NEAR(glm::length(gradient - glm::vec3(1.5f, 2.5f, -3.5f)), 0, 1e-5);
}

}  // namespace
}  // namespace sonoskin
