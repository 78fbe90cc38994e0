#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "core/base/error.h"

namespace sonoskin {
namespace {

TEST(Parallel, VisitsEveryIndexOnce) {
  std::vector<std::atomic<int>> visits(1000);
  parallelFor(1000, [&](std::ptrdiff_t i) { ++visits[std::size_t(i)]; });
  for (const auto& v : visits) EXPECT_EQ(v, 1);
}

TEST(Parallel, CarriesTheFirstExceptionOut) {
  EXPECT_THROW(parallelFor(100,
                           [](std::ptrdiff_t i) {
                             if (i == 37) throw Error("thirty-seven");
                           }),
               Error);
}

TEST(Parallel, StopsWhenCancelled) {
  ProgressSink sink;
  std::atomic<int> calls{0};
  EXPECT_THROW(parallelFor(
                   100000,
                   [&](std::ptrdiff_t) {
                     if (++calls == 10) sink.cancel = true;
                   },
                   Progress(sink)),
               Cancelled);
  EXPECT_LT(calls, 100);
}

TEST(Parallel, ReportsRisingFractions) {
  std::vector<double> seen;
  ProgressSink sink;
  sink.report = [&](double f) { seen.push_back(f); };
  setThreadCount(1);
  parallelFor(
      10, [](std::ptrdiff_t) {}, Progress(sink).part(0.5, 1));
  setThreadCount(0);
  ASSERT_EQ(seen.size(), 10u);
  EXPECT_NEAR(seen.front(), 0.55, 1e-12);
  EXPECT_NEAR(seen.back(), 1, 1e-12);
}

// Only the calling thread reports; the others may have done all the work.
TEST(Parallel, ReportsTheEndWhoeverWorked) {
  ProgressSink sink;
  double last = 0;
  sink.report = [&](double f) { last = f; };
  setThreadCount(4);
  for (int repeat = 0; repeat < 200; ++repeat) {
    last = 0;
    parallelFor(
        2, [](std::ptrdiff_t) {}, Progress(sink));
    ASSERT_EQ(last, 1) << "repeat " << repeat;
  }
  setThreadCount(0);
}

}  // namespace
}  // namespace sonoskin
