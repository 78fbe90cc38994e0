#include "core/surface/first_hit.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

// Layers across j: bright from `from` to `to`, over a dark ground that is `gap` between the layers. A surface lies on
// the near side of each.
struct Layers {
  struct Layer {
    int from, to;
  };
  Geometry geometry = test::grid({20, 60, 20});
  Volume<float> v{geometry};
  std::vector<SurfaceVoxel> voxels;

  explicit Layers(const std::vector<Layer>& layers, float gap = 0.05f) {
    for (int k = 0; k < 20; ++k)
      for (int j = 0; j < 60; ++j)
        for (int i = 0; i < 20; ++i) {
          float value = j > layers.front().to && j < layers.back().from ? gap : 0.05f;
          for (const Layer& layer : layers)
            if (j >= layer.from && j <= layer.to) value = 0.9f;
          v.at(i, j, k) = value;
        }
    for (int k = 2; k < 18; ++k)
      for (const Layer& layer : layers)
        for (int i = 2; i < 18; ++i) voxels.push_back({{i, layer.from, k}, {i, layer.from, k}, 0.9f});
  }
  // keptAt: how many of the surface voxels at that j are kept.
  std::size_t keptAt(int j, double depth, const ScanFrame& frame = {}) const {
    std::size_t count = 0;
    for (const SurfaceVoxel& s : keepFirstHits(voxels, v, frame, {0.4f, 0.15f}, depth))
      count += s.voxel.y == j;
    return count;
  }
};

constexpr std::size_t kAll = 16 * 16;

TEST(FirstHit, SkinWinsOverTheBoneBelowIt) {
  const Layers bone({{10, 13}, {20, 24}}, 0.3f);  // soft tissue between
  EXPECT_EQ(bone.keptAt(10, 15), kAll);
  EXPECT_EQ(bone.keptAt(20, 15), 0u);
  EXPECT_EQ(bone.keptAt(20, 0), kAll);  // switched off
}

TEST(FirstHit, ACheekBehindAFingerStays) {
  const Layers cheek({{10, 14}, {20, 40}}, 0.05f);  // fluid between
  EXPECT_EQ(cheek.keptAt(10, 15), kAll);
  EXPECT_EQ(cheek.keptAt(20, 15), kAll);
}

TEST(FirstHit, AWallFarBeforeHidesNothing) {
  const Layers wall({{5, 8}, {40, 50}}, 0.3f);
  EXPECT_EQ(wall.keptAt(40, 15), kAll);
  EXPECT_EQ(wall.keptAt(40, 40), 0u);
}

// What lies before must have a surface of its own: the far side of a layer that is none does not hide.
TEST(FirstHit, OnlySurfacesHide) {
  Layers bone({{10, 13}, {20, 24}}, 0.3f);
  std::erase_if(bone.voxels, [](const SurfaceVoxel& s) { return s.voxel.y == 10; });
  EXPECT_EQ(bone.keptAt(20, 15), kAll);
}

// What was erased or cut away is not there: what lies before the bone hides it only where it was left.
TEST(FirstHit, WhatWasErasedHidesNothing) {
  const Layers bone({{10, 13}, {20, 24}}, 0.3f);
  auto erased = std::make_shared<Volume<std::uint8_t>>(bone.geometry);
  for (int k = 0; k < 20; ++k)
    for (int j = 8; j < 16; ++j)
      for (int i = 10; i < 20; ++i) erased->at(i, j, k) = 1;
  ScanFrame frame;
  frame.region.erased = erased;
  EXPECT_EQ(bone.keptAt(20, 15, frame), kAll / 2);
  ScanFrame cut;
  cut.region.first = {0, 16, 0};
  EXPECT_EQ(bone.keptAt(20, 15, cut), kAll);
}

TEST(FirstHit, LooksAlongTheBeams) {
  const Layers bone({{10, 13}, {20, 24}}, 0.3f);
  Beam fromTheSide;
  fromTheSide.axis = {1, 0, 0};
  EXPECT_EQ(bone.keptAt(20, 15, {fromTheSide, {}}), kAll);
  Beam fan;
  fan.apex = glm::dvec3(10, -20, 10);
  EXPECT_EQ(bone.keptAt(20, 15, {fan, {}}), 0u);
}

// A sheet that the beam grazes is not hidden by itself.
TEST(FirstHit, ASlantedSheetDoesNotHideItself) {
  const Geometry geometry = test::grid({40, 60, 20});
  const auto v = test::fill(geometry, [](glm::dvec3 p) { return p.y > 1.4 * p.x ? 0.9 : 0.05; });
  std::vector<SurfaceVoxel> sheet;
  for (int k = 2; k < 18; ++k)
    for (int j = 3; j < 54; ++j) {
      const int i = int(j / 1.4);
      sheet.push_back({{i, j, k}, {i, j, k}, 0.9f});
    }
  EXPECT_EQ(keepFirstHits(sheet, v, {}, {0.4f, 0.15f}, 15).size(), sheet.size());
}

TEST(FirstHit, DoesNotDependOnTheNumberOfThreads) {
  const Layers bone({{10, 13}, {20, 24}}, 0.3f);
  setThreadCount(1);
  const auto one = keepFirstHits(bone.voxels, bone.v, {}, {0.4f, 0.15f}, 15);
  setThreadCount(3);
  const auto three = keepFirstHits(bone.voxels, bone.v, {}, {0.4f, 0.15f}, 15);
  setThreadCount(0);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t n = 0; n < one.size(); ++n) EXPECT_EQ(one[n].voxel, three[n].voxel);
}

TEST(FirstHit, FluidIsTheMedianOfTheDark) {
  const auto v = test::fill(test::grid({40, 40, 40}), [](glm::dvec3 p) { return p.y < 30 ? 0.1 : 0.8; });
  const FluidLevels levels = findFluidLevels(v, {}, 0.3);
  EXPECT_FLOAT_EQ(levels.iso, 0.3f);
  EXPECT_NEAR(levels.dark, 0.2, 1e-6);
}

TEST(FirstHit, StopsWhenCancelled) {
  const Layers bone({{10, 13}, {20, 24}});
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(keepFirstHits(bone.voxels, bone.v, {}, {0.4f, 0.15f}, 15, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
