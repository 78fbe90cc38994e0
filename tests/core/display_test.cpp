#include "core/phantom/display.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/base/error.h"

namespace sonoskin {
namespace {

SectorGrid sector() { return phantomSector({1.5, 1.5, 3.6}); }

std::vector<float> greysOf(const std::vector<float>& decibels, const DisplayOptions& options) {
  const SectorGrid s = sector();
  std::vector<float> v(s.samples(), 0);
  for (std::size_t n = 0; n < decibels.size(); ++n) v[n] = std::pow(10.f, decibels[n] / 20);
  showEnvelope(s, options, v);
  return {v.begin(), v.begin() + std::ptrdiff_t(decibels.size())};
}

TEST(Display, CompressesFromBlackToWhite) {
  const auto grey = greysOf({-4, -29, -54, 3, -90}, {});
  EXPECT_NEAR(grey[0], 1, 1e-5);
  EXPECT_NEAR(grey[1], 0.5, 1e-5);
  EXPECT_NEAR(grey[2], 0, 1e-4);
  EXPECT_EQ(grey[3], 1);
  EXPECT_EQ(grey[4], 0);
}

TEST(Display, SpreadsTheGreysBetweenThresholdAndCeiling) {
  DisplayOptions options;
  options.threshold = 0.25f, options.ceiling = 0.75f;
  const auto grey = greysOf({-4, -29, -42.5f, -16}, options);  // 1, 0.5, 0.23, 0.76
  EXPECT_EQ(grey[0], 1);
  EXPECT_NEAR(grey[1], 0.5, 1e-4);
  EXPECT_EQ(grey[2], 0);
  EXPECT_EQ(grey[3], 1);
}

TEST(Display, SmoothingKeepsTheMeanAndSpreadsAPoint) {
  const SectorGrid s = sector();
  std::vector<float> v(s.samples(), 0);
  const std::size_t middle = s.row(s.laterals / 2, s.elevations / 2) + std::size_t(s.ranges) / 2;
  v[middle] = 1;  // -4 dB is white: 0 dB too
  DisplayOptions options;
  options.smoothing = 2;
  showEnvelope(s, options, v);
  EXPECT_NEAR(std::accumulate(v.begin(), v.end(), 0.0), 1, 1e-3);
  EXPECT_LT(v[middle], 0.3f);
  EXPECT_GT(v[middle + 1], 0.2f * v[middle]);
  EXPECT_EQ(v[middle + 40], 0);
}

TEST(Display, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  std::vector<float> v(sector().samples(), 0);
  EXPECT_THROW(showEnvelope(sector(), {}, v, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
