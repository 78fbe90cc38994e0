#include "app/views/moving_budget.h"

#include <gtest/gtest.h>

namespace sonoskin::ui {
namespace {

// Whatever the rest of a frame takes, pictures come fifteen times a second where that can be.
TEST(MovingBudget, LeavesTimeForTheRestOfTheFrame) {
  for (const double beside : {0.0, 0.005, 0.02, 0.035}) {
    MovingBudget budget;
    for (int frame = 0; frame < 20; ++frame) budget.frame(beside + budget.seconds(), budget.seconds());
    EXPECT_LT(beside + budget.seconds(), 1.0 / 15) << beside;
    EXPECT_GT(budget.seconds(), 0.01);
  }
}

TEST(MovingBudget, FramesWithoutAPictureSayNothing) {
  MovingBudget budget;
  const double before = budget.seconds();
  budget.frame(3, 0);
  EXPECT_EQ(budget.seconds(), before);
}

}  // namespace
}  // namespace sonoskin::ui
