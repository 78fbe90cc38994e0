#include "render/gpu_volume.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/gl/read_pixels.h"
#include "tests/render/support/gl_test.h"

namespace sonoskin {
namespace {

Geometry smallGeometry() {
  Geometry g;
  g.dims = {21, 10, 17};
  g.spacing = {1, 2, 0.5};
  g.origin = {3, 4, 5};
  return g;
}

Volume<float> scattered(const Geometry& g) {
  Volume<float> volume(g);
  unsigned state = 7;
  for (float& v : volume.data) v = float((state = state * 1664525u + 1013904223u) >> 24) / 255.0f;
  return volume;
}

TEST(BrickMaxima, BoundEveryInterpolatedValueAndAreReached) {
  const Volume<float> volume = scattered(smallGeometry());
  const auto maxima = brickMaxima(volume, 8);
  ASSERT_EQ(maxima.size(), 3u * 2 * 3);
  std::vector<float> expected(maxima.size(), 0);
  for (int k = 0; k < 17; ++k)
    for (int j = 0; j < 10; ++j)
      for (int i = 0; i < 21; ++i)
        for (int b = 0; b < 18; ++b) {  // a brick's cells reach its voxels and the next ones
          const glm::ivec3 d = glm::ivec3(i, j, k) - 8 * glm::ivec3(b % 3, b / 3 % 2, b / 6);
          if (std::min({d.x, d.y, d.z}) >= 0 && std::max({d.x, d.y, d.z}) <= 8)
            expected[std::size_t(b)] = std::max(expected[std::size_t(b)], volume.at(i, j, k));
        }
  EXPECT_EQ(maxima, expected);
}

class GpuVolumeTest : public GlTest {};

TEST_F(GpuVolumeTest, UploadsOnlyOnChange) {
  GpuVolume gpu;
  EXPECT_TRUE(gpu.empty());
  const auto first = std::make_shared<Volume<float>>(scattered(smallGeometry()));
  gpu.set(first);
  const unsigned name = gpu.values().name();
  gpu.set(first);
  EXPECT_EQ(gpu.values().name(), name);
  gpu.set(std::make_shared<Volume<float>>(*first));
  EXPECT_EQ(gpu.geometry().dims, first->geometry.dims);
  gpu.set(std::shared_ptr<const Volume<float>>());
  EXPECT_TRUE(gpu.empty());
}

TEST_F(GpuVolumeTest, TakesBytesWhereTheyAreExact) {
  GpuVolume gpu;
  auto volume = scattered(smallGeometry());
  gpu.set(std::make_shared<Volume<float>>(volume));
  EXPECT_EQ(gpu.values().description().format, gl::Format::r8);
  volume.data[5] = 0.5f;
  gpu.set(std::make_shared<Volume<float>>(volume));
  EXPECT_EQ(gpu.values().description().format, gl::Format::r16);
}

TEST_F(GpuVolumeTest, IsPreparedInPieces) {
  GpuVolume gpu, whole;
  EXPECT_TRUE(gpu.prepare(0, true)) << "there is nothing to do";
  const auto volume = std::make_shared<Volume<float>>(scattered(smallGeometry()));
  gpu.set(volume);
  whole.set(volume);
  int calls = 1;
  while (!gpu.prepare(0, true)) ASSERT_LT(++calls, 20);
  EXPECT_GT(calls, 2);
  EXPECT_EQ(gl::readFloats(gpu.values(), 1), gl::readFloats(whole.values(), 1));
  EXPECT_EQ(gl::readFloats(gpu.bricks(), 1), gl::readFloats(whole.bricks(), 1));
  gpu.set(std::make_shared<Volume<float>>(*volume));
  EXPECT_FALSE(gpu.prepare(0, false)) << "another one begins anew";
}

TEST_F(GpuVolumeTest, ContentBoxHoldsWhatIsBright) {
  Volume<float> volume(smallGeometry());
  volume.at(12, 3, 9) = 0.8f;
  GpuVolume gpu;
  gpu.set(std::make_shared<Volume<float>>(volume));
  const Box box = gpu.contentBox(0.5f), all = gpu.contentBox(0.9f);
  const glm::vec3 bright(volume.geometry.toWorld({12, 3, 9}));
  EXPECT_TRUE(glm::all(glm::lessThanEqual(box.min, bright)) && glm::all(glm::lessThanEqual(bright, box.max)));
  EXPECT_LT(box.diagonal(), 0.8f * all.diagonal());
  EXPECT_FLOAT_EQ(all.max.x, 23);
}

// Addresses and the names of textures come back; what is computed for a volume is kept under its number.
TEST_F(GpuVolumeTest, NumbersNeverComeBack) {
  const auto volume = std::make_shared<const Volume<float>>(scattered(smallGeometry()));
  const auto other = std::make_shared<const Volume<float>>(scattered(smallGeometry()));
  GpuVolume first, second;
  std::uint64_t last = 0;
  for (const auto& shown : {volume, other, volume}) {
    for (GpuVolume* gpu : {&first, &second}) {
      gpu->set(shown);
      EXPECT_GT(gpu->number(), last);
      last = gpu->number();
      gpu->set(shown);
      EXPECT_EQ(gpu->number(), last) << "nothing was uploaded";
    }
  }
}

}  // namespace
}  // namespace sonoskin
