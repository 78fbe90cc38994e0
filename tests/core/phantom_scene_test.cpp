#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/phantom/phantom.h"
#include "core/phantom/phantom_geometry.h"
#include "core/phantom/phantom_model.h"
#include "core/phantom/scene_acoustics.h"
#include "core/volume/sample.h"
#include "tests/support/edge_profile.h"

namespace sonoskin {
namespace {

PhantomOptions sceneOf(PhantomScene scene, std::array<int, 3> dims = {128, 72, 36}) {
  PhantomOptions options;
  options.dims = dims;
  options.scene = scene;
  return options;
}

// eachInside: f(grey, world) for every voxel well within the scene's sector.
template <class F>
void eachInside(const PhantomOptions& options, F&& f) {
  const Scan scan = makePhantomScan(options);
  const SectorGrid sector = sceneSector(options);
  const Geometry& g = scan.volume->geometry;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i)
        if (const glm::dvec3 p = g.toWorld({i, j, k}); sector.contains(glm::vec3(p), 1))
          f(scan.volume->at(i, j, k), p);
}

double shareAtWhite(PhantomScene scene) {
  double all = 0, white = 0;
  eachInside(sceneOf(scene, {200, 110, 60}),
             [&](float v, const glm::dvec3&) { all += 1, white += v > 0.999f; });
  return white / all;
}

// zeroInFluid: the share of the fluid, 4 mm clear of everything, that is exactly 0.
double zeroInFluid(PhantomScene scene) {
  const PhantomOptions options = sceneOf(scene);
  const PhantomModel model(options);
  double all = 0, zero = 0;
  eachInside(options, [&](float v, const glm::dvec3& p) {
    if (model.skin(p) > 4 && model.other(p) > 4) all += 1, zero += v == 0;
  });
  EXPECT_GT(all, 1000);
  return zero / all;
}

// greyBefore: the mean grey of the fluid between two distances before the skin, far from the wall.
double greyBefore(PhantomScene scene, double from, double to) {
  const PhantomOptions options = sceneOf(scene, {110, 60, 36});
  const PhantomModel model(options);
  double sum = 0, count = 0;
  eachInside(options, [&](float v, const glm::dvec3& p) {
    const double d = model.skin(p);
    if (d > from && d < to && p.y < 50 && model.wall(p) > 5) sum += double(v), count += 1;
  });
  return sum / count;
}

// roughness: how far greys lie from the middle of their neighbours' across elevation, beside their steps.
double roughness(PhantomScene scene) {
  const PhantomOptions options = sceneOf(scene, {32, 64, 224});
  const Scan scan = makePhantomScan(options);
  const Volume<float>& v = *scan.volume;
  double bends = 0, steps = 0;
  for (int k = 80; k < 144; ++k)
    for (int j = 20; j < 40; ++j)
      for (int i = 0; i < 32; ++i) {
        const float a = v.at(i, j, k - 1), b = v.at(i, j, k), c = v.at(i, j, k + 1);
        bends += double(std::abs(a - 2 * b + c)), steps += double(std::abs(c - a));
      }
  return bends / steps;
}

EdgeProfile edgeOf(PhantomScene scene) {
  const PhantomOptions options = sceneOf(scene, {256, 144, 72});
  return edgeProfile(*makePhantomScan(options).volume, makePhantomTruth(options));
}

TEST(PhantomScene, SaturatedClipsItsBrightEchoes) {
  EXPECT_LT(shareAtWhite(PhantomScene::clear), 0.001);
  const double share = shareAtWhite(PhantomScene::saturated);
  EXPECT_GT(share, 0.015);
  EXPECT_LT(share, 0.04);
}

TEST(PhantomScene, EnhancedFluidIsBlack) {
  EXPECT_LT(zeroInFluid(PhantomScene::clear), 0.2);
  EXPECT_GT(zeroInFluid(PhantomScene::enhanced), 0.98);
  EXPECT_GT(zeroInFluid(PhantomScene::clinical), 0.97);
}

TEST(PhantomScene, HazeLiesBeforeTheSkinOnly) {
  const double clear = greyBefore(PhantomScene::clear, 1.5, 3), hazy = greyBefore(PhantomScene::haze, 1.5, 3);
  EXPECT_GT(hazy, clear + 0.1);
  EXPECT_LT(greyBefore(PhantomScene::haze, 3.5, 4.8), hazy - 0.03);
  EXPECT_NEAR(greyBefore(PhantomScene::haze, 6, 9), greyBefore(PhantomScene::clear, 6, 9), 0.02);
}

TEST(PhantomScene, PlanesAreCoarseAndStraightBetween) {
  const SectorGrid clear = sceneSector(sceneOf(PhantomScene::clear, {467, 255, 124}));
  for (const PhantomScene scene : {PhantomScene::planes, PhantomScene::clinical})
    for (const std::array<int, 3> dims :
         {std::array<int, 3>{467, 255, 124}, std::array<int, 3>{256, 144, 72}}) {
      const SectorGrid s = sceneSector(sceneOf(scene, dims));
      EXPECT_NEAR(s.elevationStep() * 79, 1.6, 0.08);
      EXPECT_GT(s.elevationStep(), 1.5f * clear.elevationStep());
    }
  EXPECT_LT(roughness(PhantomScene::planes), 0.8 * roughness(PhantomScene::clear));
}

// The edges of real volumes: dark side 0.03 to 0.08, bright side 0.80 to 0.91, 1.5 mm from 20 to 80 %, steepest
// at 0.46 to 0.48.
TEST(PhantomScene, ThickEchoesAreThoseOfRealVolumes) {
  for (const PhantomScene scene : {PhantomScene::thick, PhantomScene::clinical}) {
    const EdgeProfile e = edgeOf(scene);
    EXPECT_LT(e.dark, 0.1) << enumNames(scene)[std::size_t(scene)];
    EXPECT_GT(e.bright, 0.78);
    EXPECT_LT(e.bright, 0.93);
    EXPECT_GT(e.rise, 1.3);
    EXPECT_LT(e.rise, 1.75);
    EXPECT_GT(e.steepestAt, 0.4);
    EXPECT_LT(e.steepestAt, 0.53);
  }
  const EdgeProfile thin = edgeOf(PhantomScene::clear);
  EXPECT_LT(thin.rise, 1.3);
  EXPECT_LT(thin.bright, 0.6);
}

TEST(PhantomScene, EveryOneIsAnotherScan) {
  std::vector<Key> keys;
  for (const PhantomScene scene :
       {PhantomScene::clear, PhantomScene::thick, PhantomScene::haze, PhantomScene::saturated,
        PhantomScene::enhanced, PhantomScene::planes, PhantomScene::attached})
    keys.push_back(makePhantomScan(sceneOf(scene, {64, 36, 70})).key);
  PhantomOptions other = sceneOf(PhantomScene::clear, {64, 36, 70});
  other.shape = 3;
  keys.push_back(makePhantomScan(other).key);
  for (std::size_t a = 0; a < keys.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(keys[a] == keys[b]) << a << ' ' << b;
}

TEST(PhantomScene, RefusesAShapeThatIsOutOfRange) {
  PhantomOptions options = sceneOf(PhantomScene::clear);
  options.shape = -1;
  EXPECT_THROW(makePhantomScan(options), Error);
  EXPECT_THROW(makePhantomTruth(options), Error);
}

}  // namespace
}  // namespace sonoskin
