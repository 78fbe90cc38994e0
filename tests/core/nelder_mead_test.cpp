#include "core/skin/nelder_mead.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sonoskin {
namespace {

double square(double x) { return x * x; }

TEST(NelderMead, FindsTheEndOfABentValley) {
  const auto valley = [](const std::vector<double>& p) {
    return square(1 - p[0]) + 100 * square(p[1] - p[0] * p[0]);
  };
  const Minimum found = findMinimum(valley, {-1.2, 1}, {0.3, 1e-12, 2000});
  EXPECT_NEAR(found.place[0], 1, 1e-4);
  EXPECT_NEAR(found.place[1], 1, 1e-4);
  EXPECT_NEAR(found.value, 0, 1e-8);
}

TEST(NelderMead, StridesGrowWhileItGoesDownhill) {
  const auto far = [](const std::vector<double>& p) { return square(p[0] - 5000) + square(p[1] - 3000); };
  const Minimum found = findMinimum(far, {0, 0}, {0.3, 1e-10, 300});
  EXPECT_NEAR(found.place[0], 5000, 1);
}

TEST(NelderMead, AsksNoMoreOftenThanAllowed) {
  int asked = 0;
  const auto bowl = [&](const std::vector<double>& p) {
    ++asked;
    return square(p[0] - 3) + square(p[1]) + square(p[2]) + 1;
  };
  findMinimum(bowl, {0, 0, 0}, {0.3, 0, 100});
  EXPECT_LE(asked, 104);
  asked = 0;
  EXPECT_NEAR(findMinimum(bowl, {0, 0, 0}, {0.3, 1e-10, 1000}).place[0], 3, 1e-3);
  EXPECT_LT(asked, 300) << "the tolerance ends it";
}

}  // namespace
}  // namespace sonoskin
