#include "core/classification/half.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

namespace sonoskin {
namespace {

// Every half that Eigen knows in the range, and the way back.
TEST(Half, AreThoseOfIeee) {
  for (std::uint32_t bits = 0x0400; bits <= 0x7BFF; ++bits) {
    const float value = float(Eigen::numext::bit_cast<Eigen::half>(std::uint16_t(bits)));
    ASSERT_EQ(toFloat(Half(bits)), value);
    ASSERT_EQ(toHalf(value), bits);
  }
}

TEST(Half, IsTheNearest) {
  for (float value = 7e-5f; value < 60000; value *= 1.00137f)
    ASSERT_NEAR(toFloat(toHalf(value)), value, value * 0x1.01p-11f);
}

TEST(Half, EndsWhereItsRangeEnds) {
  EXPECT_EQ(toFloat(toHalf(0)), kLeastHalf);
  EXPECT_EQ(toFloat(toHalf(-1)), kLeastHalf);
  EXPECT_EQ(toFloat(toHalf(1e9f)), kGreatestHalf);
}

}  // namespace
}  // namespace sonoskin
