#include "core/base/task_pool.h"

#include <gtest/gtest.h>

#include <chrono>
#include <latch>
#include <set>
#include <thread>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

using namespace std::chrono_literals;

// So many threads, however many processors there are.
class TaskPoolTest : public ::testing::Test {
 protected:
  void SetUp() override { setThreadCount(3); }
  void TearDown() override { setThreadCount(0); }
};

TEST_F(TaskPoolTest, HelpersWorkAtTheSameTime) {
  std::latch all(3);  // nobody gets by before three have come
  TaskPool::instance().share([&] { all.arrive_and_wait(); }, 2);
  EXPECT_TRUE(all.try_wait());
}

TEST_F(TaskPoolTest, NoMoreComeThanAreWanted) {
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::atomic<int> calls{0};
    TaskPool::instance().share(
        [&] {
          ++calls;
          std::this_thread::sleep_for(200us);
        },
        1);
    ASSERT_GE(calls, 1);
    ASSERT_LE(calls, 2);
  }
}

TEST_F(TaskPoolTest, EveryCallHasEndedAtTheEnd) {
  for (int repeat = 0; repeat < 500; ++repeat) {
    std::atomic<int> inside{0};
    TaskPool::instance().share(
        [&] {
          ++inside;
          if (repeat % 3 == 0) std::this_thread::yield();
          --inside;
        },
        2);
    ASSERT_EQ(inside, 0) << "repeat " << repeat;
  }
}

TEST_F(TaskPoolTest, LoopsWithinLoopsEnd) {
  std::atomic<long> sum{0};
  parallelFor(20, [&](std::ptrdiff_t i) {
    parallelFor(
        20, [&](std::ptrdiff_t j) { parallelFor(3, [&](std::ptrdiff_t k) { sum += i * 60 + j * 3 + k; }); });
  });
  EXPECT_EQ(sum, 1199L * 1200 / 2);
}

TEST_F(TaskPoolTest, SeveralThreadsShareItsHelpers) {
  std::atomic<int> visits{0};
  std::vector<std::thread> callers;
  for (int c = 0; c < 4; ++c)
    callers.emplace_back([&] {
      for (int repeat = 0; repeat < 100; ++repeat) parallelFor(50, [&](std::ptrdiff_t) { ++visits; });
    });
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(visits, 4 * 100 * 50);
}

// Loops beside each other, and within each other, add no threads. More than any other test asks for: the pool keeps them.
TEST_F(TaskPoolTest, ThreadsAreAsManyAsWereAskedFor) {
  constexpr int kThreads = 12;
  setThreadCount(kThreads);
  std::mutex mutex;
  std::set<std::thread::id> seen;
  parallelFor(2 * kThreads, [&](std::ptrdiff_t) {
    parallelFor(2 * kThreads, [&](std::ptrdiff_t) {
      std::this_thread::sleep_for(100us);
      const std::lock_guard lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
  });
  EXPECT_LE(seen.size(), std::size_t(kThreads));
}

TEST_F(TaskPoolTest, AnExceptionWithinALoopWithinALoopComesOut) {
  EXPECT_THROW(parallelFor(10,
                           [](std::ptrdiff_t i) {
                             parallelFor(10, [&](std::ptrdiff_t j) {
                               if (i == 7 && j == 3) throw std::runtime_error("in the middle");
                             });
                           }),
               std::runtime_error);
}

// Whoever waits does not burn the processor that others want.
TEST_F(TaskPoolTest, WaitingTakesNoProcessorTime) {
  const auto used = [] {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
  };
  parallelFor(3, [](std::ptrdiff_t) {});  // the helpers are there, and go to sleep
  const double before = used();
  parallelFor(2, [](std::ptrdiff_t i) {
    if (i == 0) std::this_thread::sleep_for(300ms);
  });
  EXPECT_LT(used() - before, 0.1);  // a thread that spins takes 0.3
}

}  // namespace
}  // namespace sonoskin
