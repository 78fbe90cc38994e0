#include "core/base/parallel_blocks.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/base/error.h"

namespace sonoskin {
namespace {

TEST(ParallelBlocks, CutsIntoBlocksOfTheSizeAndARest) {
  std::vector<std::pair<std::size_t, std::size_t>> blocks(blockCount(10, 4));
  parallelBlocks(10, 4, [&](std::size_t first, std::size_t end) { blocks[first / 4] = {first, end}; });
  EXPECT_EQ(blocks, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 4}, {4, 8}, {8, 10}}));
}

TEST(ParallelBlocks, MeetsEveryItemOnce) {
  for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 1000u}) {
    std::vector<int> met(count, 0);
    parallelItems(count, 64, [&](std::size_t i) { ++met[i]; });
    EXPECT_EQ(met, std::vector<int>(count, 1)) << count;
  }
}

TEST(ParallelBlocks, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(parallelItems(
                   10, 4, [](std::size_t) {}, Progress(sink)),
               Cancelled);
}

}  // namespace
}  // namespace sonoskin
