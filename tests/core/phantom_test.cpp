#include "core/phantom/phantom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/phantom/scene_world.h"
#include "core/phantom/sector_grid.h"
#include "tests/support/first_phantom.h"

namespace sonoskin {
namespace {

PhantomOptions smallOptions() {
  PhantomOptions options;
  options.dims = {94, 51, 31};
  return options;
}

struct Statistics {
  double n = 0, sum = 0, squares = 0;
  void add(double v) { n += 1, sum += v, squares += v * v; }
  double mean() const { return sum / n; }
  double variance() const { return squares / n - mean() * mean(); }
};

// contrastToNoise: (mean of the skin - mean of the fluid) / sqrt(mean of their variances), grey values.
double contrastToNoise(double snr) {
  PhantomOptions options;
  options.dims = {156, 170, 62};
  options.snr = snr;
  const Scan scan = makePhantomScan(options);
  const Geometry& g = scan.volume->geometry;
  const SectorGrid sector = phantomSector(g.spacing);
  Statistics skin, fluid;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const glm::dvec3 p = g.toWorld({i, j, k});
        if (p.y > 45 || !sector.contains(glm::vec3(p), 4)) continue;
        const double d = test::skinDistance(p);
        if (std::abs(d + 0.45) < 0.45) {
          const double ahead = test::skinDistance(p - 0.2 * scan.beam->directionAt(p));
          if (ahead - d > 0.14) skin.add(scan.volume->at(i, j, k));  // cosine above 0.7
        } else if (d > 3 && test::wallDistance(p) > 3 && p.y < 35) {
          fluid.add(scan.volume->at(i, j, k));
        }
      }
  return (skin.mean() - fluid.mean()) / std::sqrt(0.5 * (skin.variance() + fluid.variance()));
}

TEST(Phantom, KeepsItsFieldOfViewWhateverItsSize) {
  for (const auto dims : {std::array<int, 3>{94, 51, 31}, std::array<int, 3>{40, 64, 20}}) {
    PhantomOptions options;
    options.dims = dims;
    const Scan scan = makePhantomScan(options);
    const Geometry& g = scan.volume->geometry;
    EXPECT_EQ(g.dims, glm::ivec3(dims[0], dims[1], dims[2]));
    EXPECT_NEAR(glm::distance(g.spacing * glm::dvec3(g.dims), kFieldOfView), 0, 1e-9);
    EXPECT_NEAR(glm::distance(g.toWorld(glm::dvec3(g.dims) - 0.5), kFieldOfView), 0, 1e-9);
  }
}

TEST(Phantom, SaysWhatItIs) {
  const Scan scan = makePhantomScan(smallOptions());
  EXPECT_EQ(scan.originalType, "uint8");
  EXPECT_EQ(scan.originalMax, 255);
  EXPECT_TRUE(scan.spacingKnown);
  ASSERT_TRUE(scan.beam && scan.beam->apex);
  EXPECT_EQ(scan.beam->up, glm::dvec3(-1, 0, 0));
  EXPECT_EQ(scan.key, scanKey(*scan.volume, scan.beam));
  std::set<int> greys;
  for (float v : scan.volume->data) {
    ASSERT_NEAR(v * 255, std::round(v * 255), 1e-4);
    greys.insert(int(std::lround(v * 255)));
  }
  EXPECT_GT(greys.size(), 100u);
}

TEST(Phantom, IsBlackOutsideTheSectorAndOnlyThere) {
  const Scan scan = makePhantomScan(smallOptions());
  const Geometry& g = scan.volume->geometry;
  const SectorGrid sector = phantomSector(g.spacing);
  int inside = 0, black = 0;
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const glm::vec3 p(g.toWorld({i, j, k}));
        if (!sector.contains(p, -0.01f)) {
          ASSERT_EQ(scan.volume->at(i, j, k), 0);
        }
        if (sector.contains(p, 0.01f)) ++inside, black += scan.volume->at(i, j, k) == 0;
      }
  EXPECT_LT(black, inside / 10);
}

TEST(Phantom, IsTheSameOnAnyNumberOfThreads) {
  setThreadCount(1);
  const Key one = makePhantomScan(smallOptions()).key;
  setThreadCount(3);
  const Key three = makePhantomScan(smallOptions()).key;
  setThreadCount(0);
  EXPECT_EQ(one, three);
}

TEST(Phantom, AnotherSeedIsAnotherScan) {
  PhantomOptions options = smallOptions();
  const Key first = makePhantomScan(options).key;
  options.seed = 2;
  EXPECT_FALSE(makePhantomScan(options).key == first);
}

TEST(Phantom, ContrastFollowsTheSignal) {
  const double poor = contrastToNoise(5), usual = contrastToNoise(20), clean = contrastToNoise(35);
  EXPECT_LT(poor, usual - 1);
  EXPECT_GT(clean, usual + 0.5);
  EXPECT_GT(usual, 5);
  EXPECT_LT(usual, 7);
}

TEST(Phantom, RefusesWhatIsOutOfRange) {
  PhantomOptions thin = smallOptions(), silent = smallOptions(), seedless = smallOptions();
  thin.dims = {94, 8, 31};
  silent.snr = -1;
  seedless.seed = -4;
  for (const PhantomOptions& options : {thin, silent, seedless}) {
    EXPECT_THROW(makePhantomScan(options), Error);
    EXPECT_THROW(makePhantomTruth(options), Error);
  }
}

TEST(Phantom, StopsWhenCancelledAndReportsRisingProgress) {
  ProgressSink sink;
  double last = 0;
  sink.report = [&](double f) {
    EXPECT_GE(f, last - 1e-9);
    last = f;
    if (f > 0.6) sink.cancel = true;
  };
  EXPECT_THROW(makePhantomScan(smallOptions(), Progress(sink)), Cancelled);
  EXPECT_LT(last, 0.9);
}

}  // namespace
}  // namespace sonoskin
