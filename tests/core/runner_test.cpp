#include "core/pipeline/runner.h"

#include <gtest/gtest.h>

#include <chrono>

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

TEST(Runner, TheLatestRequestWins) {
  Runner runner;
  auto r = request(64);
  for (int n = 1; n <= 5; ++n) {
    r.parameters.classification.isoValue = 0.2 + 0.05 * n;
    runner.submit(r);
  }
  const auto results = untilIdle(runner);
  ASSERT_FALSE(results.empty());
  EXPECT_NEAR(results.back().isoValue, 0.45, 1e-12);
}

TEST(Runner, PreviewComesFirst) {
  Runner runner;
  auto r = request(64);
  r.previewFirst = true;
  runner.submit(r);
  const auto results = untilIdle(runner);
  ASSERT_FALSE(results.empty());
  EXPECT_EQ(results.back().classified->geometry.dims, glm::ivec3(64));
  if (results.size() > 1) {
    EXPECT_EQ(results.front().classified->geometry.dims, glm::ivec3(16));
  }
}

TEST(Runner, CancelEndsTheRequestWithoutAnError) {
  Runner runner;
  runner.submit(request(128));
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
  untilIdle(runner);
  EXPECT_NE(runner.status().error.find("classification.gamma"), std::string::npos);
}

TEST(Runner, EndsWhileItWorks) {
  const auto start = std::chrono::steady_clock::now();
  {
    Runner runner;
    runner.submit(request(160));
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

}  // namespace
}  // namespace sonoskin
