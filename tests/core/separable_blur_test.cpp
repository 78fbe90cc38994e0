#include "core/phantom/separable_blur.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/phantom/random_field.h"

namespace sonoskin {
namespace {

TEST(SeparableBlur, TapsKeepMeanOrPower) {
  double sum = 0, squares = 0;
  for (float w : gaussTaps(1.7f, Keep::mean)) sum += w;
  for (float w : gaussTaps(1.7f, Keep::power)) squares += w * w;
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_NEAR(squares, 1, 1e-6);
  EXPECT_EQ(gaussTaps(0, Keep::mean), std::vector<float>{1});
}

TEST(SeparableBlur, EqualsTheSumOverNeighbours) {
  const int n = 23;
  const std::vector<float> taps = gaussTaps(1.2f, Keep::mean);
  const int reach = int(taps.size()) / 2;
  std::vector<float> in(n), scratch;
  for (int i = 0; i < n; ++i) in[std::size_t(i)] = uniformAt(std::uint32_t(i), 3);
  std::vector<float> row = in, columns(3 * n);
  for (int i = 0; i < n; ++i)
    for (int c = 0; c < 2; ++c) columns[std::size_t(3 * i + c)] = in[std::size_t(i)] * float(c + 1);
  blurRow(row.data(), n, taps, scratch);
  blurAcross(columns.data(), n, 3, 2, taps, scratch);
  for (int i = 0; i < n; ++i) {
    float expected = 0;
    for (int t = -reach; t <= reach; ++t)
      if (i + t >= 0 && i + t < n) expected += taps[std::size_t(t + reach)] * in[std::size_t(i + t)];
    EXPECT_NEAR(row[std::size_t(i)], expected, 1e-6);
    EXPECT_NEAR(columns[std::size_t(3 * i + 1)], 2 * expected, 1e-6);
    EXPECT_EQ(columns[std::size_t(3 * i + 2)], 0) << "beyond the width";
  }
}

}  // namespace
}  // namespace sonoskin
