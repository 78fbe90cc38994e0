#include "core/base/disjoint_sets.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

TEST(DisjointSets, BeginsWithEveryItemAlone) {
  DisjointSets sets(3);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(sets.isRoot(i));
    EXPECT_EQ(sets.root(i), i);
  }
}

// A chain that is joined from its far end, so that roots lie deep.
TEST(DisjointSets, TheFirstItemIsTheRoot) {
  constexpr std::uint32_t kCount = 1000;
  DisjointSets sets(kCount);
  for (std::uint32_t i = kCount - 1; i > 1; i -= 1) sets.join(i, i - 1);
  EXPECT_EQ(sets.root(kCount - 1), 1u);
  EXPECT_TRUE(sets.isRoot(0));
  sets.join(0, 500);
  for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(sets.root(i), 0u);
  sets.join(3, 7);  // of one set already
  EXPECT_EQ(sets.root(7), 0u);
}

TEST(DisjointSets, JoinsIntoTheSetThatIsNamed) {
  DisjointSets sets(5);
  sets.joinInto(0, 3);
  sets.joinInto(3, 4);
  EXPECT_EQ(sets.root(0), 4u);
  EXPECT_FALSE(sets.isRoot(3));
  sets.joinInto(0, 3);
  EXPECT_EQ(sets.root(3), 4u);
  EXPECT_EQ(sets.root(1), 1u);
}

}  // namespace
}  // namespace sonoskin
