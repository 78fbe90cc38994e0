#include "core/pipeline/stage.h"

#include <gtest/gtest.h>

namespace sonoskin {
namespace {

TEST(Stage, RemembersTheMostRecentlyUsed) {
  Stage<int> stage(2);
  const Key a{0, 1}, b{0, 2}, c{0, 3};
  stage.remember(a, 10);
  stage.remember(b, 20);
  ASSERT_TRUE(stage.find(a));  // now b is the oldest
  stage.remember(c, 30);
  EXPECT_EQ(*stage.find(a), 10);
  EXPECT_EQ(*stage.find(c), 30);
  EXPECT_FALSE(stage.find(b));
}

}  // namespace
}  // namespace sonoskin
