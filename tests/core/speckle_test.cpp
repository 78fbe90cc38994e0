#include "core/phantom/speckle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr NoiseLevels kSilent{-200, -200};

// Fine steps: the smoothing of the display, which is counted in samples, then changes nothing.
SectorGrid fineSector() { return {400, 120, 24, 45, 0.05f, 0.25f, 0.2f, {0, -45, 0}}; }

const std::vector<float>& uniformSpeckle() {
  static const std::vector<float> envelope = speckleEnvelope(
      fineSector(), std::vector<float>(fineSector().samples(), 0.3f), PointSpread{}, kSilent, 1);
  return envelope;
}

// correlation: of the intensity at samples `lag` apart in memory, over the inner part of the sector.
double correlation(const std::vector<float>& envelope, std::ptrdiff_t lag) {
  const SectorGrid s = fineSector();
  double a = 0, aa = 0, ab = 0, n = 0;
  for (int k = 4; k < s.elevations - 4; ++k)
    for (int j = 15; j < s.laterals - 15; ++j)
      for (int i = 20; i < s.ranges - 20; ++i) {
        const auto at = std::ptrdiff_t(s.row(j, k)) + i;
        const double x = std::pow(envelope[std::size_t(at)], 2),
                     y = std::pow(envelope[std::size_t(at + lag)], 2);
        a += x, aa += x * x, ab += x * y, n += 1;
      }
  return (ab / n - a * a / n / n) / (aa / n - a * a / n / n);
}

TEST(Speckle, IsFullyDeveloped) {
  const SectorGrid s = fineSector();
  double sum = 0, squares = 0, n = 0;
  for (int k = 4; k < s.elevations - 4; ++k)
    for (int j = 15; j < s.laterals - 15; ++j)
      for (int i = 20; i < s.ranges - 20; ++i) {
        const double v = uniformSpeckle()[s.row(j, k) + std::size_t(i)];
        sum += v, squares += v * v, n += 1;
      }
  const double mean = sum / n, deviation = std::sqrt(squares / n - mean * mean);
  EXPECT_NEAR(squares / n, 0.09, 0.004);
  EXPECT_NEAR(mean / deviation, std::sqrt(M_PI / (4 - M_PI)), 0.06);  // 1.913: Rayleigh  [Burckhardt 1978]
}

// The intensity of Gaussian speckle is correlated like the square of the point spread's autocorrelation:
// exp(-lag^2 / (2 sigma^2)).
TEST(Speckle, IsAsCoarseAsThePointSpread) {
  const SectorGrid s = fineSector();
  const PointSpread spread;
  for (int lag : {3, 5}) {
    const double x = double(lag) * s.rangeStep / spread.range;
    EXPECT_NEAR(correlation(uniformSpeckle(), lag), std::exp(-0.5 * x * x), 0.05);
  }
  const double y = s.lateralStep() / spread.lateral, z = s.elevationStep() / spread.elevation;
  EXPECT_NEAR(correlation(uniformSpeckle(), std::ptrdiff_t(s.row(1, 0))), std::exp(-0.5 * y * y), 0.05);
  EXPECT_NEAR(correlation(uniformSpeckle(), std::ptrdiff_t(s.row(0, 1))), std::exp(-0.5 * z * z), 0.08);
}

TEST(Speckle, DoesNotDependOnThreads) {
  SectorGrid s = fineSector();
  s.laterals = 40;
  const auto run = [&](int threads) {
    setThreadCount(threads);
    auto envelope = speckleEnvelope(s, std::vector<float>(s.samples(), 0.1f), PointSpread{}, {-40, -30}, 5);
    setThreadCount(0);
    return envelope;
  };
  EXPECT_EQ(run(1), run(3));
}

TEST(Speckle, NoiseIsWhatRemainsWithoutEchoes) {
  const SectorGrid s = fineSector();
  const auto noise = speckleEnvelope(s, std::vector<float>(s.samples(), 0.f), PointSpread{}, {-40, -200}, 2);
  double first = 0, last = 0;
  for (int k = 0; k < s.elevations; ++k)
    for (int j = 0; j < s.laterals; ++j)
      for (int i = 5; i < 25; ++i) {
        first += noise[s.row(j, k) + std::size_t(i)];
        last += noise[s.row(j, k) + std::size_t(s.ranges - i)];
      }
  EXPECT_NEAR(first / (20. * s.laterals * s.elevations), 0.01 * std::sqrt(M_PI) / 2, 0.0005);
  EXPECT_NEAR(last / first, std::pow(10, 8 / 20.) / 1.05, 0.1) << "the gain rises by 8 dB over the depth";
}

TEST(Speckle, ClutterSpreadsEchoesIntoTheirNeighbourhood) {
  const SectorGrid s = fineSector();
  std::vector<float> amplitude(s.samples(), 0.f);
  for (int i = 0; i < s.ranges; ++i) amplitude[s.row(60, 12) + std::size_t(i)] = 1;
  const std::size_t middle = s.row(0, 12) + 200;
  const auto before = amplitude;
  addClutter(s, amplitude, {-200, -20});
  const auto at = [&](int j) { return amplitude[middle + s.row(j, 0)]; };
  EXPECT_GT(at(64), at(75));
  EXPECT_GT(at(75), at(110));
  EXPECT_GT(at(64), 0.005f);
  EXPECT_LT(at(64), 0.1f);
  EXPECT_GE(at(60), before[middle + s.row(60, 0)]);
}

TEST(Speckle, StopsWhenCancelled) {
  const SectorGrid s = fineSector();
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(speckleEnvelope(s, std::vector<float>(s.samples()), PointSpread{}, kSilent, 1, Progress(sink)),
               Cancelled);
}

}  // namespace
}  // namespace sonoskin
