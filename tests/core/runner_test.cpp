#include "core/pipeline/runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "core/base/timer.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

Runner::Request request(int size = 40) {
  Runner::Request r;
  auto volume = std::make_shared<Volume<float>>(
      test::speckledSphere(test::grid(glm::ivec3(size)), glm::dvec3(0.5 * size), 0.3 * size, 0.1));
  r.scan.key = scanKey(*volume, {});
  r.scan.volume = volume;
  r.parameters.mesh.resolution = 40;
  return r;
}

// Whether a condition holds within ten seconds.
template <class Condition>
bool until(const Runner& runner, Condition holds) {
  for (int n = 0; n < 10000; ++n) {
    if (holds(runner.status())) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

bool untilItWorks(const Runner& runner) {
  return until(runner, [](const Runner::Status& s) { return s.busy && !s.stage.empty(); });
}

// Polls as the window does, until the runner is idle.
std::vector<Results> untilIdle(Runner& runner) {
  std::vector<Results> all;
  for (int n = 0; n < 2000; ++n) {
    const bool busy = runner.status().busy;
    if (auto results = runner.takeResults()) all.push_back(std::move(*results));
    if (!busy) return all;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ADD_FAILURE() << "the runner did not finish";
  return all;
}

TEST(Runner, DeliversTheResult) {
  Runner runner;
  auto r = request();
  r.goal = Goal::mesh;
  runner.submit(r);
  const auto results = untilIdle(runner);
  ASSERT_FALSE(results.empty());
  EXPECT_TRUE(results.back().mesh);
  EXPECT_EQ(runner.status().finished, 1u);
  EXPECT_EQ(runner.status().error, "");
}

// The first one is at work, the next two wait, each for much longer than it takes to submit the last.
TEST(Runner, TheLatestRequestWins) {
  Runner runner;
  auto slow = request(160), last = request();
  slow.parameters.classification.isoValue = 0.3;
  runner.submit(slow);
  ASSERT_TRUE(untilItWorks(runner));
  for (const double isoValue : {0.35, 0.4}) {
    slow.parameters.classification.isoValue = isoValue;
    runner.submit(slow);
  }
  last.parameters.classification.isoValue = 0.45;
  runner.submit(last);
  const auto results = untilIdle(runner);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_NEAR(results[0].isoValue, 0.45, 1e-12);
  EXPECT_EQ(results[0].classified->geometry.dims, glm::ivec3(40));
  EXPECT_EQ(runner.status().finished, 1u) << "the others were cancelled or not begun";
  EXPECT_FALSE(runner.status().cancelled) << "by nobody's wish";
}

TEST(Runner, ResultsOfAnEarlierRequestAreNotTaken) {
  Runner runner;
  runner.submit(request());
  ASSERT_TRUE(until(runner, [](const Runner::Status& s) { return !s.busy; }));
  runner.submit(request(160));
  EXPECT_FALSE(runner.takeResults());
}

TEST(Runner, PreviewComesFirst) {
  Runner runner;
  auto r = request(160);
  r.previewFirst = true;
  runner.submit(r);
  const auto results = untilIdle(runner);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].classified->geometry.dims, glm::ivec3(40));
  EXPECT_EQ(results[1].classified->geometry.dims, glm::ivec3(160));
  EXPECT_EQ(runner.status().finished, 1u);
}

TEST(Runner, SlicesThatAreLookedAtComeBeforeThat) {
  Runner runner;
  auto r = request(160);
  runner.submit(r);
  untilIdle(runner);
  r.parameters.classification.beta *= 1.5;
  r.previewFirst = true;
  r.slicesFirst = glm::ivec3(80);
  runner.submit(r);
  const auto results = untilIdle(runner);
  ASSERT_GE(results.size(), 2u);
  const auto slices = [](const Results& some) {
    return std::ranges::count_if(some.slices, [](const auto& slice) { return slice != nullptr; });
  };
  EXPECT_GE(slices(results[0]), 1) << "one does not wait for the others";
  EXPECT_FALSE(results[0].classified);
  EXPECT_EQ(slices(results.back()), 0) << "the volume is there";
  EXPECT_TRUE(results.back().classified);
}

TEST(Runner, CancelEndsTheRequestWithoutAnError) {
  Runner runner;
  runner.submit(request(128));
  ASSERT_TRUE(untilItWorks(runner));
  runner.cancel();
  EXPECT_TRUE(untilIdle(runner).empty());
  EXPECT_TRUE(runner.status().cancelled);
  EXPECT_EQ(runner.status().error, "");
  EXPECT_EQ(runner.status().finished, 0u);
  runner.submit(request());  // and works again
  EXPECT_FALSE(untilIdle(runner).empty());
}

TEST(Runner, TellsWhyARequestFailed) {
  Runner runner;
  auto r = request();
  r.parameters.classification.gamma = 1e9;
  runner.submit(r);
  EXPECT_TRUE(untilIdle(runner).empty());
  EXPECT_NE(runner.status().error.find("classification.gamma"), std::string::npos);
  EXPECT_EQ(runner.status().finished, 0u);
  runner.submit(request());
  EXPECT_EQ(runner.status().error, "") << "the next one begins without it";
}

TEST(Runner, ForgetsTheResultsOfAnotherDocument) {
  Runner runner;
  auto first = request();
  first.previewFirst = true;
  const std::weak_ptr<const Volume<float>> volume = first.scan.volume;
  runner.submit(std::move(first));
  std::vector<std::weak_ptr<const Volume<float>>> older;
  for (const Results& results : untilIdle(runner)) older.push_back(results.classified);
  ASSERT_FALSE(older.empty());
  EXPECT_FALSE(older.back().expired()) << "somebody may come back to it";
  runner.submit(request());  // still waits, or runs, when the other document opens
  runner.forget();
  EXPECT_FALSE(runner.takeResults());
  runner.submit(request(44));
  const auto results = untilIdle(runner);
  ASSERT_FALSE(results.empty());
  EXPECT_EQ(results.back().classified->geometry.dims, glm::ivec3(44));
  for (const auto& result : older) EXPECT_TRUE(result.expired());
  EXPECT_TRUE(volume.expired());
}

TEST(Runner, EndsWhileItWorks) {
  auto slow = request(128);  // half a minute
  slow.goal = Goal::mesh;
  slow.parameters.reconstruction.method = ReconstructionMethod::global;
  slow.parameters.global.accuracy = 0.01;
  auto runner = std::make_unique<Runner>();
  runner->submit(slow);
  ASSERT_TRUE(untilItWorks(*runner));
  const Timer timer;
  runner.reset();
  EXPECT_LT(timer.seconds(), 5);
}

}  // namespace
}  // namespace sonoskin
