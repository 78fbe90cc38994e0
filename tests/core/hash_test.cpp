#include "core/base/hash.h"

#include <gtest/gtest.h>

#include <vector>

namespace sonoskin {
namespace {

TEST(Hasher, DependsOnNameContentAndOrder) {
  const Key ab = Hasher("x").add(1).add(2).key();
  EXPECT_EQ(ab, Hasher("x").add(1).add(2).key());
  EXPECT_NE(ab, Hasher("x").add(2).add(1).key());
  EXPECT_NE(ab, Hasher("y").add(1).add(2).key());
}

TEST(Hasher, LengthIsPartOfAList) {
  const std::vector<int> two{1, 2}, one{1};
  EXPECT_NE(Hasher("x").add(std::span<const int>(two)).key(),
            Hasher("x").add(std::span<const int>(one)).add(2).key());
}

TEST(Key, HexIsThirtyTwoDigits) {
  EXPECT_EQ((Key{0x1, 0xabc}).hex(), "00000000000000010000000000000abc");
  EXPECT_FALSE(bool(Key{}));
}

}  // namespace
}  // namespace sonoskin
