#include "core/volume/histogram.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

TEST(Quantile, AgreesWithSorting) {
  Volume<float> volume(test::grid({21, 17, 13}));
  for (std::size_t i = 0; i < volume.data.size(); ++i) volume.data[i] = float(std::pow(test::noise(i), 3));
  auto sorted = volume.data;
  std::sort(sorted.begin(), sorted.end());
  for (const double share : {0.01, 0.5, 0.9, 0.998})
    EXPECT_NEAR(quantile(volume, share), sorted[std::size_t(share * double(sorted.size()))], 0.003) << share;
}

TEST(Quantile, TakesValuesBeyondTheRangeAsItsEnds) {
  Volume<float> volume(test::grid({4, 4, 4}), 7.0f);
  EXPECT_EQ(quantile(volume, 0.5), 1);
  volume.data.assign(64, -3.0f);
  EXPECT_NEAR(quantile(volume, 0.5), 0, 0.001);
}

TEST(Quantile, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(quantile(Volume<float>(test::grid({4, 4, 4})), 0.5, Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
