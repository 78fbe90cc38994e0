#include "tests/benchmarks/accuracy/settings.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace sonoskin::accuracy {
namespace {

TEST(AccuracySettings, WhatIsSetStaysUnlessAnOptionSaysOtherwise) {
  Given given;
  given.sets = {"phantom.seed=77", "surface.facing=0.1"};
  EXPECT_EQ(parametersOf(given).phantom.seed, 77);
  EXPECT_EQ(parametersOf(given).surface.facing, 0.1);
  EXPECT_EQ(parametersOf(given).phantom.dims, PhantomOptions{}.dims);
  given.seed = 5;
  given.dims = {64, 32, 16};
  EXPECT_EQ(parametersOf(given).phantom.seed, 5);
  EXPECT_EQ(parametersOf(given).phantom.dims, (std::array<int, 3>{64, 32, 16}));
}

TEST(AccuracySettings, KnowsWhatIsNamed) {
  const Given given{{"phantom.seed=77"}, {}, {}};
  EXPECT_TRUE(given.names("phantom.seed"));
  EXPECT_FALSE(given.names("phantom.see"));
  EXPECT_FALSE(given.names("phantom.scene"));
}

TEST(AccuracySettings, RefusesWhatIsNoParameter) {
  EXPECT_THROW(parametersOf({{"phantom.seed"}, {}, {}}), Error);
  EXPECT_THROW(parametersOf({{"phantom.colour=1"}, {}, {}}), Error);
  EXPECT_THROW(parametersOf({{"phantom.scene=fog"}, {}, {}}), Error);
}

}  // namespace
}  // namespace sonoskin::accuracy
