#include "core/volume/box_blur.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/support/test_volumes.h"
#include "tests/support/thesis_matrix.h"

namespace sonoskin {
namespace {

TEST(BoxBlur, IsTheMeanOf27VoxelsWithTheBorderRepeated) {
  const auto v = test::speckledSphere(test::grid({9, 5, 4}, {1, 2, 3}), {4, 4, 4}, 3, 0.5);
  const auto expected = test::boxMeans<double>(v);
  const auto blurred = boxBlur(v);
  EXPECT_EQ(blurred.geometry.spacing, v.geometry.spacing);
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_NEAR(blurred.data[i], expected[i], 1e-6) << i;
}

TEST(BoxBlur, StopsWhenCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(boxBlur(Volume<float>(test::grid({4, 4, 4})), Progress(sink)), Cancelled);
}

}  // namespace
}  // namespace sonoskin
