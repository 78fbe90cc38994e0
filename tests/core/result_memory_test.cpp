#include "core/pipeline/result_memory.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

const Key kA{0, 1}, kB{0, 2}, kC{0, 3}, kD{0, 4};

// Results of a hundred bytes each, in a memory of three.
class ResultMemoryTest : public ::testing::Test {
 protected:
  ResultMemory memory{300};

  std::weak_ptr<const int> remember(const Key& key, int value) {
    const auto result = std::make_shared<const int>(value);
    memory.remember(key, result, 100);
    return result;
  }
  // Without using it.
  static bool lives(const std::weak_ptr<const int>& result) { return !result.expired(); }
};

TEST_F(ResultMemoryTest, TheOldestUseGoesFirst) {
  memory.beginRun(false);
  const auto a = remember(kA, 10), b = remember(kB, 20), c = remember(kC, 30);
  memory.beginRun(false);
  ASSERT_TRUE(memory.find<int>(kA));  // now b is the oldest
  const auto d = remember(kD, 40);
  EXPECT_TRUE(lives(a) && lives(c) && lives(d));
  EXPECT_FALSE(lives(b));
  EXPECT_FALSE(memory.find<int>(kB));
  EXPECT_EQ(*memory.find<int>(kC), 30);
  memory.beginRun(false);
  const auto large = std::make_shared<const int>(50);
  memory.remember(kB, large, 200);
  EXPECT_FALSE(lives(a) || lives(d)) << "as many go as it takes, in the order of their use";
  EXPECT_TRUE(lives(c));
}

TEST_F(ResultMemoryTest, WhatTheRunUsesStaysWhateverItTakes) {
  memory.beginRun(false);
  const auto a = remember(kA, 10), b = remember(kB, 20), c = remember(kC, 30), d = remember(kD, 40);
  EXPECT_TRUE(lives(a) && lives(b) && lives(c) && lives(d));
  memory.beginRun(false);
  ASSERT_TRUE(memory.find<int>(kA));
  remember({0, 5}, 50);
  EXPECT_TRUE(lives(a) && lives(d)) << "used by this run, and the last of the others";
  EXPECT_FALSE(lives(b) || lives(c));
}

// A slider in motion leaves many answers behind, and none pushes out what a person waited for.
TEST_F(ResultMemoryTest, WhatWasAskedForOutlivesTheAnswersOfSliders) {
  memory.beginRun(true);
  const auto asked = remember(kA, 10);
  std::weak_ptr<const int> last;
  for (int n = 0; n < 20; ++n) {
    memory.beginRun(false);
    last = remember({1, std::uint64_t(n)}, n);
  }
  EXPECT_TRUE(lives(asked) && lives(last));
  memory.beginRun(false);
  ASSERT_TRUE(memory.find<int>({1, 19}));
  memory.beginRun(true);
  ASSERT_TRUE(memory.find<int>({1, 19})) << "asked for by now";
  remember(kB, 20);
  remember(kC, 30);
  EXPECT_FALSE(lives(asked)) << "the oldest of what was asked for";
  EXPECT_TRUE(lives(last));
}

TEST_F(ResultMemoryTest, AResultOfAnotherKindIsNone) {
  remember(kA, 10);
  EXPECT_FALSE(memory.find<double>(kA));
}

TEST_F(ResultMemoryTest, ForgettingGivesAllBack) {
  const auto a = remember(kA, 10);
  memory.forget();
  EXPECT_FALSE(lives(a));
  EXPECT_FALSE(memory.find<int>(kA));
  memory.beginRun(false);
  const auto b = remember(kB, 20), c = remember(kC, 30), d = remember(kD, 40);
  memory.beginRun(false);
  EXPECT_TRUE(lives(b) && lives(c) && lives(d)) << "and none of it is counted any more";
}

}  // namespace
}  // namespace sonoskin
